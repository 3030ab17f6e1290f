function turns = fingerTurns(place, others)
% How the fingers may be turned to hold a block at a place: directions from finger to finger [rad], 1xN;
% they go across its longer side, and only where nothing is in their way.
%   place  position, yaw and size of the block
  turns = place.yaw + [pi / 2, -pi / 2];
  if place.size(1) < 1.1 * place.size(2), turns = [turns, place.yaw + [0, pi]]; end
  fits = true(1, numel(turns));
  for i = 1:numel(turns)
    for other = others
      fits(i) = fits(i) && ~isInTheWay(other, place, turns(i));
    end
  end
  turns = turns(fits);
end

function yes = isInTheWay(other, place, across)
% The fingers are 0.4 thick, and 0.15 away from the block when open; the hand above them is round.
  top = other.position(3) + other.size(3) / 2;
  yes = false;
  if top < place.position(3) - place.size(3) / 2 + 0.02, return; end
  body = footprint(other, 0.04);
  for side = [-1, 1]
    gap = side * (place.size(2) / 2 + 0.35) * [cos(across), sin(across)];
    finger = struct('center', place.position(1:2) + gap, 'sides', [0.4, 0.3], 'yaw', across);
    yes = yes || overlap(finger, body);
  end
  if top > place.position(3) + place.size(3) / 2 + 0.4
    hand = struct('center', place.position(1:2), 'sides', [1.5, 1.5], 'yaw', across);
    yes = yes || overlap(hand, body);
  end
end
