function steps = placeByWhatStays(steps, known, arms, eye)
% Moves steps to where the objects that the demonstration did not move are seen here, in any rotation. A
% 1x0 struct array if they are not seen in the same arrangement, or the arms do not reach.
  anchor = steps(find([steps.stays], 1));
  sites = {};
  cost = [];
  if ~isempty(anchor)
    turns = [0, 1, -1, 2] * pi / 2;
    if ~hasEqualSides(anchor), turns = [0, pi]; end
    for block = known(arrayfun(@(it) isSameKind(it, anchor), known))
      for rotation = yawDifference(anchor, block.yaw) + turns
        moved = turnedAbout(anchor, steps, rotation, block);
        stays = moved([steps.stays]);
        is_there = false(numel(stays), numel(known));
        for k = 1:numel(stays), is_there(k, :) = arrayfun(@(it) isInPlace(it, stays(k)), known); end
        if ~all(any(is_there, 2)), continue; end
        rest = known(~any(is_there, 1));
        turning = constants().building_site.rotated_cost * abs(rotation);
        cost(end + 1) = turning + siteCost(moved, rest, eye);
        sites{end + 1} = moved;
      end
    end
  end
  steps = firstWithinReach(cost, sites, arms);
end

function steps = turnedAbout(anchor, steps, rotation, block)
% Returns the steps as they are when an anchor is where a block is, after a rotation [rad].
  for k = 1:numel(steps)
    away = rotated(steps(k).position(1:2) - anchor.position(1:2), rotation);
    steps(k).position(1:2) = block.position(1:2) + away;
    steps(k).yaw = steps(k).yaw + rotation;
  end
end
