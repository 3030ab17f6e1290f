function building = chooseSite(building, robot, picture, eye)
% Chooses where the building shall stand, and shifts the steps there: what goes into a container to where
% that is seen, what is drawn from where it is known to be, all else to where there is room. Without such
% a site, hasSite stays false and the summary says so.
  trouble = '';
  is_drawn = arrayfun(@isDrawn, building.steps);
  carried = building.steps(~is_drawn);
  if ~isempty(building.container)
    [carried, building.container, trouble] = ...
        intoContainer(carried, building.container, picture, eye);
  elseif ~isempty(carried)
    [carried, trouble] = onTable(carried, building.known, robot);
  end
  building.steps(~is_drawn) = carried;
  for k = find(is_drawn)
    [building.steps(k), building.summary] = drawnFromHere(building.steps(k), building.known);
    if ~isempty(building.summary), return; end
  end
  building.summary = trouble;
  building.hasSite = isempty(trouble);
end

function [step, trouble] = drawnFromHere(step, known)
% From the one block that looks like what was drawn, along the same way as seen from it.
  trouble = '';
  found = known(arrayfun(@(block) isLike(block, step), known));
  if numel(found) ~= 1
    trouble = sprintf('%d things are seen that look like %s', numel(found), describeStep(step));
    return
  end
  turn = turnBetween(step, found.yaw);
  step.way = turned(step.way, turn);
  step.position = found.position + [step.way, 0];
  step.yaw = step.yaw + turn;
end

function [steps, container, trouble] = intoContainer(steps, container, picture, eye)
% As they lay in the container.
  trouble = '';
  [found, turn] = findContainer(picture, eye, container);
  if isempty(found)
    trouble = sprintf('the container %s cannot be seen', container.name);
    return
  end
  for k = 1:numel(steps)
    way = turned(steps(k).position(1:2) - container.position(1:2), turn);
    steps(k).position(1:2) = found.position(1:2) + way;
    steps(k).yaw = steps(k).yaw + turn;
  end
  container = found;
end

function [steps, trouble] = onTable(steps, known, robot)
% Where the arms reach each place, with few blocks in the way.
  trouble = '';
  c = constants().decide;
  shown = vertcat(steps.position);
  middle = (min(shown, [], 1) + max(shown, [], 1)) / 2;
  [x, y] = ndgrid(c.site_x(1):c.site_x(2):c.site_x(3), c.site_y(1):c.site_y(2):c.site_y(3));
  % Far from the robot the building hides little, and near it the arms reach more.
  cost = c.far_site_cost * abs(y - c.best_site_y) + c.side_site_cost * abs(x);
  for i = 1:numel(x)
    there = shift(steps, [x(i), y(i)] - middle(1:2));
    for block = known
      if isWalledIn(block, there), cost(i) = cost(i) + block.size(1); end
    end
  end
  [~, order] = sort(cost(:));
  for i = order'
    there = shift(steps, [x(i), y(i)] - middle(1:2));
    if all(arrayfun(@(step) isWithinReach(robot, 1 + (step.position(1) > 0), step), there))
      steps = there;
      return
    end
  end
  trouble = 'no place on the table is within reach for all of the building';
end

function steps = shift(steps, way)
  for k = 1:numel(steps), steps(k).position(1:2) = steps(k).position(1:2) + way; end
end

function way = turned(way, angle)
  way = [way(1) * cos(angle) - way(2) * sin(angle), way(1) * sin(angle) + way(2) * cos(angle)];
end
