function building = chooseSite(building, robot)
% Chooses where the building shall stand: where the arms reach each place, with few blocks in the way.
% The steps are shifted there. Without such a site, hasSite stays false and the summary says so.
  shown = vertcat(building.steps.position);
  middle = (min(shown, [], 1) + max(shown, [], 1)) / 2;
  [x, y] = ndgrid(-1.5:0.75:1.5, -2.25:0.5:-0.75);
  % Far from the robot the building hides little, and near it the arms reach more.
  cost = 0.1 * abs(y + 1.25) + 0.01 * abs(x);
  for i = 1:numel(x)
    steps = shift(building.steps, [x(i), y(i)] - middle(1:2));
    for block = building.known
      if isWalledIn(block, steps), cost(i) = cost(i) + block.size(1); end
    end
  end
  [~, order] = sort(cost(:));
  for i = order'
    steps = shift(building.steps, [x(i), y(i)] - middle(1:2));
    if all(arrayfun(@(step) isWithinReach(robot, 1 + (step.position(1) > 0), step), steps))
      building.steps = steps;
      building.hasSite = true;
      return
    end
  end
  building.summary = 'no place on the table is within reach for all of the building';
end

function steps = shift(steps, way)
  for k = 1:numel(steps), steps(k).position(1:2) = steps(k).position(1:2) + way; end
end
