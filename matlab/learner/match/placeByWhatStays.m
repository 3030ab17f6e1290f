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
  [sites, cost] = sitesByAnchor(steps, known, eye);
  steps = firstWithinReach(cost, sites, arms);
end

function groups = groupsOf(steps)
% Returns the numbers of the steps that stand on each other or are around each other, directly or not: a 1xN cell.
  groups = {};
  for k = 1:numel(steps)
    is_below = cellfun(@(group) any(arrayfun(@(it) isPlacedBy(steps(k), it), steps(group))), groups);
    groups = [groups(~is_below), {sort([groups{is_below}, k])}];
  end
end
