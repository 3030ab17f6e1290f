function turns = fingerTurns(place, others)
% How the fingers may be turned to hold a block at a place: directions from finger to finger [rad], 1xN;
% they go across its longer side, and only where nothing is in their way.
%   place  position, yaw and size of the block
  turns = place.yaw + [pi / 2, -pi / 2];
  if place.size(1) < 1.1 * place.size(2), turns = [turns, place.yaw + [0, pi]]; end
  low = place.position(3) - place.size(3) / 2 + 0.02;
  high = place.position(3) + place.size(3) / 2 + 0.4;
  tops = arrayfun(@(other) other.position(3) + other.size(3) / 2, others);
  at_fingers = footprint(others(tops > low), 0.04);
  at_hand = footprint(others(tops > high), 0.04);
  fits = arrayfun(@(turn) fingersFit(place, turn, at_fingers, at_hand), turns);
  turns = turns(fits);
end

function yes = fingersFit(place, across, at_fingers, at_hand)
% The fingers are 0.4 thick, and 0.15 away from the block when open; the hand above them is round.
  gap = (place.size(2) / 2 + 0.35) * [cos(across), sin(across)];
  at = place.position(1:2);
  yes = ~any(overlap([at + gap, 0.4, 0.3, across], at_fingers)) && ...
        ~any(overlap([at - gap, 0.4, 0.3, across], at_fingers)) && ...
        ~any(overlap([at, 1.5, 1.5, across], at_hand));
end
