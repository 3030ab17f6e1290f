function [state, problem] = chooseSite(state, arms, picture, eye)
% Chooses the site of the building and moves the steps there: steps for a container to where it is detected,
% dragged steps to the detected object, others to the objects that the demonstration did not move, or to a
% free site on the table. If there is no such site, state.hasSite stays false and problem says why.
  problem = '';
  is_dragged = arrayfun(@isDragged, state.steps);
  carried = state.steps(~is_dragged);
  if ~isempty(state.container)
    [carried, state.container, problem] = placeInContainer(carried, state.container, state.known, picture, eye);
  elseif ~isempty(carried)
    placed = placeByWhatStays(carried, state.known, arms, eye);
    if isempty(placed), [placed, problem] = placeOnTable(carried, state.known, arms, eye); end
    carried = placed;
  end
  if isempty(problem), state.steps(~is_dragged) = carried; end
  for k = find(is_dragged)
    if isempty(problem), [state.steps(k), problem] = placeDragged(state.steps(k), state.known); end
  end
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
