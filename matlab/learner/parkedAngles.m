function q = parkedAngles(arm)
% Returns the joint angles, 1x7 [rad], of a parked arm: turned outward, beside the table and above the
% building, outside the eye's view and the other arm's way. The fingers point straight down.
  c = constants().motion_planning;
  q = c.parked_left_rad';
  if arm == 2, q = q .* c.parked_mirror'; end  % the right arm mirrors the left
end
