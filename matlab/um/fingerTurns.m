function turns = fingerTurns(place, others)
% How the fingers may be turned to hold a block at a place: directions from finger to finger [rad], 1xN;
% they go across its longer side, and only where nothing is in their way.
%   place  position, yaw and size of the block
  turns = place.yaw + [pi / 2, -pi / 2];
  if hasEqualSides(place), turns = [turns, place.yaw + [0, pi]]; end
  if isempty(others), return; end
  % What is as high as the fingers, the bar that joins them, and the hand above it, must keep off them.
  at = vertcat(others.position);
  sizes = vertcat(others.size);
  tops = at(:, 3) + sizes(:, 3) / 2;
  covered = footprint(others, 0.03);
  top = place.position(3) + place.size(3) / 2;
  at_fingers = covered(tops > top - place.size(3) + 0.02, :);
  at_bar = covered(tops > top + 0.3, :);
  at_hand = covered(tops > top + 0.6, :);
  ok = false(1, numel(turns));
  for i = 1:numel(turns), ok(i) = fits(place, turns(i), at_fingers, at_bar, at_hand); end
  turns = turns(ok);
end

function yes = fits(place, across, at_fingers, at_bar, at_hand)
% Fingers are 0.3 thick and 0.4 wide, and open 0.1 away from the block; the bar is 2.6 long.
  at = place.position(1:2);
  gap = (place.size(2) / 2 + 0.25) * [cos(across), sin(across)];
  yes = ~any(overlap([at + gap, 0.3, 0.4, across], at_fingers)) && ...
        ~any(overlap([at - gap, 0.3, 0.4, across], at_fingers)) && ...
        ~any(overlap([at, 2.6, 0.4, across], at_bar)) && ...
        ~any(overlap([at, 1.3, 1.3, across], at_hand));
end
