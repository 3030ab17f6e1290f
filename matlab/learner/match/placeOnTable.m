function [steps, problem] = placeOnTable(steps, known, arms, eye)
% Moves steps to the site with the lowest cost at which the nearest arm reaches each place.
  problem = '';
  c = constants().building_site;
  demonstrated = vertcat(steps.position);
  center = (min(demonstrated, [], 1) + max(demonstrated, [], 1)) / 2;
  [x, y] = ndgrid(c.x(1):c.x(2):c.x(3), c.y(1):c.y(2):c.y(3));
  % Far from the robot the building occludes little; close to it the arms reach more.
  cost = c.far_cost * abs(y - c.best_y) + c.side_cost * abs(x);
  sites = cell(1, numel(x));
  for i = 1:numel(x)
    sites{i} = shift(steps, [x(i), y(i)] - center(1:2));
    cost(i) = cost(i) + siteCost(sites{i}, known, eye);
  end
  steps = firstWithinReach(cost, sites, arms);
  if isempty(steps), problem = 'the building is not within reach anywhere on the table'; end
end

function steps = shift(steps, displacement)
  for k = 1:numel(steps), steps(k).position(1:2) = steps(k).position(1:2) + displacement; end
end
