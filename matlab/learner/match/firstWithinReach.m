function steps = firstWithinReach(cost, sites, arms, all_carried)
% Returns the steps of the cheapest site at which the nearest arm reaches each place to which something
% goes; a 1x0 struct array if there is none.
%   all_carried  whether what stayed in the demonstration has to be carried there, too; omitted for false
  if nargin < 4, all_carried = false; end
  [~, order] = sort(cost(:));
  for i = order'
    steps = sites{i};
    if all(arrayfun(@(step) (step.stays && ~all_carried) || isReachedByNearest(arms, step), steps)), return; end
  end
  steps = struct([]);
end

function yes = isReachedByNearest(arms, step)
  arms = nearestFirst(arms, step.position(1));
  yes = isReachable(arms(1), step);
end
