function turns = fingerTurns(place, others)
% How the fingers may be turned to hold a block at a place: directions from finger to finger [rad], 1xN;
% they go across its longer side, and only where nothing is in their way.
%   place  position, yaw and size of the block
  turns = place.yaw + [pi / 2, -pi / 2];
  if hasEqualSides(place), turns = [turns, place.yaw + [0, pi]]; end
  if isempty(others), return; end
  c = constants().room;
  % What is as high as the fingers, the bar that joins them, and the hand above it, must keep off them.
  at = vertcat(others.position);
  sizes = vertcat(others.size);
  tops = at(:, 3) + sizes(:, 3) / 2;
  covered = footprint(others, c.margin);
  top = place.position(3) + place.size(3) / 2;
  at_fingers = covered(tops > top - place.size(3) + c.finger_depth_margin, :);
  at_bar = covered(tops > top + c.bar_above_top, :);
  at_hand = covered(tops > top + c.hand_above_top, :);
  ok = false(1, numel(turns));
  for i = 1:numel(turns), ok(i) = fits(place, turns(i), at_fingers, at_bar, at_hand); end
  turns = turns(ok);
end

function yes = fits(place, across, at_fingers, at_bar, at_hand)
% Whether fingers that are open beside the block, the bar that joins them and the hand have room.
  c = constants().room;
  at = place.position(1:2);
  gap = (place.size(2) / 2 + c.finger_gap) * [cos(across), sin(across)];
  yes = ~any(overlap([at + gap, c.finger', across], at_fingers)) && ...
        ~any(overlap([at - gap, c.finger', across], at_fingers)) && ...
        ~any(overlap([at, c.bar', across], at_bar)) && ...
        ~any(overlap([at, c.hand', across], at_hand));
end
