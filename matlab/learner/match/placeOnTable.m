function [steps, problem] = placeOnTable(steps, known, arms, eye)
% Moves steps to the site with the lowest cost at which the nearest arm reaches each place.
  problem = '';
  c = constants().building_site;
  for depths = {c.depth, c.near_depth}
    [cost, sites] = sitesAt(steps, depths{1}(1):depths{1}(2):depths{1}(3), known, eye);
    moved = firstWithinReach(cost, sites, arms, true);
    if isempty(moved), continue; end
    steps = moved;
    return
  end
  steps = struct([]);
  problem = 'the building is not within reach anywhere on the table';
end

function [cost, sites] = sitesAt(steps, depths, known, eye)
% Returns sites on the table at some distances from its near edge [units]: the cost of each, and its steps, a 1xN cell.
  c = constants().building_site;
  demonstrated = vertcat(steps.position);
  center = (min(demonstrated, [], 1) + max(demonstrated, [], 1)) / 2;
  [x, depth] = ndgrid(c.x(1):c.x(2):c.x(3), depths);
  % Far from the robot the building occludes little; close to it the arms reach more.
  cost = c.far_cost * abs(depth - c.best_depth) + c.side_cost * abs(x);
  sites = cell(1, numel(x));
  for i = 1:numel(x)
    sites{i} = shift(steps, [x(i), nearEdge(eye) + depth(i)] - center(1:2));
    cost(i) = cost(i) + siteCost(sites{i}, known, eye);
  end
  is_on = cellfun(@(moved) all(isOnTable(footprint(moved, 0), eye)), sites);
  cost = cost(is_on);
  sites = sites(is_on);
end

function steps = shift(steps, displacement)
  for k = 1:numel(steps), steps(k).position(1:2) = steps(k).position(1:2) + displacement; end
end
