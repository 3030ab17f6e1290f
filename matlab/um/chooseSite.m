function building = chooseSite(building, seen, robot)
% Chooses where the building shall stand: where the arms reach each place, with few blocks in the way.
% The steps are shifted there. Without such a site, hasSite stays false and the summary says so.
  shown = vertcat(building.steps.position);
  middle = (min(shown, [], 1) + max(shown, [], 1)) / 2;
  covered = footprint(seen, 0.1);
  [x, y] = ndgrid(-1:0.5:1, -3.5:0.25:-0.5);
  cost = zeros(size(x));
  for i = 1:numel(x)
    rooms = gripRoom(shift(building.steps, [x(i), y(i)] - middle(1:2)));
    for k = 1:size(rooms, 1), cost(i) = cost(i) + sum(overlap(rooms(k, :), covered)); end
  end
  % Far from the robot the building hides nothing, and nearer the arms reach more.
  cost = cost + 0.1 * abs(y + 1.25) + 0.01 * abs(x);
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
