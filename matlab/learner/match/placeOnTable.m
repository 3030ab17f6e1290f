function [steps, problem] = placeOnTable(steps, known, arms, eye)
% Moves steps to the site with the lowest cost at which the nearest arm reaches each place.
  problem = '';
  c = constants().building_site;
  demonstrated = vertcat(steps.position);
  center = (min(demonstrated, [], 1) + max(demonstrated, [], 1)) / 2;
  [x, depth] = ndgrid(c.x(1):c.x(2):c.x(3), c.depth(1):c.depth(2):c.depth(3));
  % Far from the robot the building occludes little; close to it the arms reach more.
  cost = c.far_cost * abs(depth - c.best_depth) + c.side_cost * abs(x);
  sites = cell(1, numel(x));
  for i = 1:numel(x)
    sites{i} = shift(steps, [x(i), nearEdge(eye) + depth(i)] - center(1:2));
    cost(i) = cost(i) + siteCost(sites{i}, known, eye);
  end
  is_on = cellfun(@(moved) all(isOnTable(footprint(moved, 0), eye)), sites);
  steps = firstWithinReach(cost(is_on), sites(is_on), arms, true);
  if isempty(steps), problem = 'the building is not within reach anywhere on the table'; end
end

function steps = shift(steps, displacement)
  for k = 1:numel(steps), steps(k).position(1:2) = steps(k).position(1:2) + displacement; end
end
