function q = parkedAngles(arm)
% The angles of an arm that is turned outwards, beside the table and higher than what is built: out of
% the eye's sight and of the other arm's way. The fingers point straight down.
  q = [1.315, -1.0540, -0.95, 1.795, 0.4738, 1.0776, -0.2123];
  if arm == 2, q = q .* [-1, 1, -1, 1, -1, 1, -1]; end  % the right arm is the left one in a mirror
end
