function steps = placeByWhatStays(steps, known, arms, eye)
% Moves steps to where the objects that the demonstration did not move are seen here, in any rotation. If they are
% not seen in the same arrangement, each of them determines where the steps on it go. A 1x0 struct array if they
% are not seen, or the arms do not reach.
  whole = siteByAnchor(steps, known, arms, eye);
  if ~isempty(whole)
    steps = whole;
    return
  end
  free = known;
  for group = groupsOf(steps)
    placed = siteByAnchor(steps(group{1}), free, arms, eye);
    if isempty(placed)
      steps = struct([]);
      return
    end
    steps(group{1}) = placed;
    % Of objects that look alike, each carries one group.
    free = free(~any(areInPlace(free, placed([placed.stays])), 1));
  end
end

function steps = siteByAnchor(steps, known, arms, eye)
% Returns the steps of the cheapest site at which known blocks are where steps stay, see firstWithinReach.
  anchor = steps(find([steps.stays], 1));
  sites = {};
  cost = [];
  if ~isempty(anchor)
    turns = [0, 1, -1, 2] * pi / 2;
    if ~hasEqualSides(anchor), turns = [0, pi]; end
    for block = known(arrayfun(@(it) isSameKind(it, anchor), known))
      for rotation = yawDifference(anchor, block.yaw) + turns
        moved = turnedAbout(anchor, steps, rotation, block);
        is_there = areInPlace(known, moved([moved.stays]));
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

function yes = areInPlace(blocks, steps)
% Returns which of N blocks are in the places of M steps: MxN logical.
  yes = false(numel(steps), numel(blocks));
  for k = 1:numel(steps), yes(k, :) = arrayfun(@(it) isInPlace(it, steps(k)), blocks); end
end

function groups = groupsOf(steps)
% Returns the numbers of the steps that stand on each other, directly or not: a 1xN cell.
  groups = {};
  for k = 1:numel(steps)
    is_below = cellfun(@(group) any(arrayfun(@(it) standsOn(steps(k), it), steps(group))), groups);
    groups = [groups(~is_below), {sort([groups{is_below}, k])}];
  end
end
