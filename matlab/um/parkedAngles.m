function q = parkedAngles(arm)
% The angles of an arm that is turned outwards, beside the table and higher than what is built: out of
% the eye's sight and of the other arm's way. The fingers point straight down.
  c = constants().carry;
  q = c.parked_left_rad';
  if arm == 2, q = q .* c.parked_mirror'; end  % the right arm is the left one in a mirror
end
