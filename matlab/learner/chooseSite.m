function state = chooseSite(state, arms, picture, eye)
% Chooses the site of the building and moves the steps there: steps for a container to where it is
% detected, dragged steps to the detected object, all others to a free site on the table. If there is no
% such site, state.hasSite stays false and state.summary says why.
  problem = '';
  is_dragged = arrayfun(@isDragged, state.steps);
  carried = state.steps(~is_dragged);
  if ~isempty(state.container)
    [carried, state.container, problem] = placeInContainer(carried, state.container, picture, eye);
  elseif ~isempty(carried)
    [carried, problem] = placeOnTable(carried, state.known, arms);
  end
  state.steps(~is_dragged) = carried;
  for k = find(is_dragged)
    [state.steps(k), state.summary] = placeDragged(state.steps(k), state.known);
    if ~isempty(state.summary), return; end
  end
  state.summary = problem;
  state.hasSite = isempty(problem);
end

function [step, problem] = placeDragged(step, known)
% Moves a dragged step to the one known block that looks like it; rotates its displacement likewise.
  problem = '';
  found = known(arrayfun(@(block) isSameKind(block, step), known));
  if numel(found) ~= 1
    problem = sprintf('%d visible objects look like %s', numel(found), describeStep(step));
    return
  end
  rotation = yawDifference(step, found.yaw);
  step.displacement = rotated(step.displacement, rotation);
  step.position = found.position + [step.displacement, 0];
  step.yaw = step.yaw + rotation;
end

function [steps, container, problem] = placeInContainer(steps, container, picture, eye)
% Moves steps together with their container to where it is detected.
  problem = '';
  [found, rotation] = detectContainer(picture, eye, container);
  if isempty(found)
    problem = sprintf('the container %s is not visible', container.name);
    return
  end
  for k = 1:numel(steps)
    displacement = rotated(steps(k).position(1:2) - container.position(1:2), rotation);
    steps(k).position(1:2) = found.position(1:2) + displacement;
    steps(k).yaw = steps(k).yaw + rotation;
  end
  container = found;
end

function [steps, problem] = placeOnTable(steps, known, arms)
% Moves steps to the site with the lowest cost at which the nearest arm reaches each place.
  problem = '';
  c = constants().task_planning;
  demonstrated = vertcat(steps.position);
  center = (min(demonstrated, [], 1) + max(demonstrated, [], 1)) / 2;
  [x, y] = ndgrid(c.site_x(1):c.site_x(2):c.site_x(3), c.site_y(1):c.site_y(2):c.site_y(3));
  % Far from the robot the building occludes little; close to it the arms reach more.
  cost = c.far_site_cost * abs(y - c.best_site_y) + c.side_site_cost * abs(x);
  for i = 1:numel(x)
    moved = shift(steps, [x(i), y(i)] - center(1:2));
    for block = known
      if isGraspBlocked(block, moved), cost(i) = cost(i) + block.size(1); end
    end
  end
  [~, order] = sort(cost(:));
  for i = order'
    moved = shift(steps, [x(i), y(i)] - center(1:2));
    if all(arrayfun(@(step) isReachedByNearest(arms, step), moved))
      steps = moved;
      return
    end
  end
  problem = 'the building is not within reach anywhere on the table';
end

function yes = isReachedByNearest(arms, step)
  arms = nearestFirst(arms, step.position(1));
  yes = isReachable(arms(1), step);
end

function steps = shift(steps, displacement)
  for k = 1:numel(steps), steps(k).position(1:2) = steps(k).position(1:2) + displacement; end
end

function v = rotated(v, angle)
  v = [v(1) * cos(angle) - v(2) * sin(angle), v(1) * sin(angle) + v(2) * cos(angle)];
end
