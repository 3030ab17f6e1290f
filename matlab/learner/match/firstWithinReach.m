function steps = firstWithinReach(cost, sites, arms, all_carried)
% Returns the steps of the cheapest site at which the nearest arm reaches each place to which something
% goes; a 1x0 struct array if there is none.
%   all_carried  whether what stayed in the demonstration has to be carried there, too; omitted for false
  if nargin < 4, all_carried = false; end
  [~, order] = sort(cost(:));
  for i = order'
    steps = sites{i};
    isReached = @(step) (step.stays && ~all_carried) || isReachedByNearest(arms, step);
    if all(arrayfun(isReached, steps)) && canAllBePushed(steps, arms), return; end
  end
  steps = struct([]);
end

function yes = isReachedByNearest(arms, step)
  arms = nearestFirst(arms, step.position(1));
  yes = isReachable(arms(1), step);
end

function yes = canAllBePushed(steps, arms)
% Returns true if the arms can push each of some steps to its place where those before leave no room for fingers, as far as there
% is a way to push it.
  yes = true;
  for k = find(~[steps.stays])
    before = asBlocks(steps(1:k - 1));
    if ~isempty(graspYaws(steps(k), before)) || isempty(pushWays(steps(k), steps(k), before)), continue; end
    yes = yes && ~isempty(wayToPush(arms, steps(k), before));
  end
end
