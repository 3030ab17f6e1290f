function yaws = graspYaws(place, others)
% Returns the collision-free yaws of the gripper at a place: directions from finger to finger [rad], 1xN.
% The fingers close across the longer side; no other block may be in their way.
%   place   position, yaw and size of the block
%   others  obstacles, as blocks
  yaws = place.yaw + [pi / 2, -pi / 2];
  if hasEqualSides(place), yaws = [yaws, place.yaw + [0, pi]]; end
  if isempty(others), return; end
  c = constants().clearance;
  % Obstacles as high as the fingers, as the bar that joins them, and as the hand above it.
  at = vertcat(others.position);
  sizes = vertcat(others.size);
  tops = at(:, 3) + sizes(:, 3) / 2;
  covered = footprint(others, c.margin);
  top = place.position(3) + place.size(3) / 2;
  at_fingers = covered(tops > top - place.size(3) + c.finger_depth_margin, :);
  at_bar = covered(tops > top + c.bar_above_top, :);
  at_hand = covered(tops > top + c.hand_above_top, :);
  ok = false(1, numel(yaws));
  for i = 1:numel(yaws), ok(i) = isGripperClear(place, yaws(i), at_fingers, at_bar, at_hand); end
  yaws = yaws(ok);
end

function yes = isGripperClear(place, across, at_fingers, at_bar, at_hand)
% Returns true if the open fingers beside the block, the bar that joins them and the hand have room.
%   across  direction from finger to finger [rad]
  c = constants().clearance;
  at = place.position(1:2);
  gap = (place.size(2) / 2 + c.finger_gap) * [cos(across), sin(across)];
  yes = ~any(overlap([at + gap, c.finger', across], at_fingers)) && ...
        ~any(overlap([at - gap, c.finger', across], at_fingers)) && ...
        ~any(overlap([at, c.bar', across], at_bar)) && ...
        ~any(overlap([at, c.hand', across], at_hand));
end
