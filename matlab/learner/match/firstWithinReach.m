function steps = firstWithinReach(cost, sites, arms)
% Returns the steps of the cheapest site at which the nearest arm reaches each place to which something
% goes; a 1x0 struct array if there is none.
  [~, order] = sort(cost(:));
  for i = order'
    steps = sites{i};
    if all(arrayfun(@(step) step.stays || isReachedByNearest(arms, step), steps)), return; end
  end
  steps = struct([]);
end

function yes = isReachedByNearest(arms, step)
  arms = nearestFirst(arms, step.position(1));
  yes = isReachable(arms(1), step);
end
