function yaws = graspYaws(place, others)
% Returns the collision-free yaws of the gripper at a place: directions from finger to finger [rad], 1xN.
% The fingers stand beside the two longer sides and close across the shorter one; no other block may be in
% their way.
%   place   a block or a step
%   others  obstacles, as blocks
  place = heldPart(place);
  yaws = place.yaw + [pi / 2, -pi / 2];
  if hasEqualSides(place), yaws = [yaws, place.yaw + [0, pi]]; end
  if isRound(place), yaws = [yaws, yaws + pi / 4]; end
  if isempty(others), return; end
  c = constants().clearance;
  covered = footprint(others, c.margin);
  % Most are too far away to touch the gripper.
  reach = max([place.size(2) / 2 + c.finger_gap + norm(c.finger) / 2, norm(c.bar) / 2, norm(c.hand) / 2]);
  away = hypot(covered(:, 1) - place.position(1), covered(:, 2) - place.position(2));
  is_near = away < reach + hypot(covered(:, 3), covered(:, 4)) / 2;
  if ~any(is_near), return; end
  others = others(is_near);
  covered = covered(is_near, :);
  % Obstacles as high as the fingers, as the bar that joins them, and as the hand above it.
  at = vertcat(others.position);
  sizes = vertcat(others.size);
  tops = at(:, 3) + sizes(:, 3) / 2;
  top = place.position(3) + place.size(3) / 2;
  at_fingers = covered(tops > top - place.size(3) + c.finger_depth_margin, :);
  % Low blocks are held closer to their tops, so that the bar is higher.
  above = max(0, c.bar_reach - place.size(3));
  at_bar = covered(tops > top + c.bar_above_top + above, :);
  at_hand = covered(tops > top + c.hand_above_top, :);
  yaws = yaws(isGripperClear(place, yaws, at_fingers, at_bar, at_hand));
end

function yes = isGripperClear(place, across, at_fingers, at_bar, at_hand)
% Returns true, 1xN logical, if the open fingers beside the block, the bar that joins them and the hand
% have room.
%   across  directions from finger to finger [rad], 1xN
  c = constants().clearance;
  across = across(:);
  gap = (place.size(2) / 2 + c.finger_gap) * [cos(across), sin(across)];
  one = ones(numel(across), 1);
  at = one * place.position(1:2);
  yes = ~any(overlap([at + gap, one * c.finger', across], at_fingers), 1) & ...
        ~any(overlap([at - gap, one * c.finger', across], at_fingers), 1) & ...
        ~any(overlap([at, one * c.bar', across], at_bar), 1) & ...
        ~any(overlap([at, one * c.hand', across], at_hand), 1);
end
