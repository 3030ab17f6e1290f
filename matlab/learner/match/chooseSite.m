function [state, problem] = chooseSite(state, arms, picture, eye)
% Chooses the site of the building and moves the steps there: steps for a container to where it is detected, dragged
% steps to the detected object, those that take the place of another object to where that is, those with an anchor to
% their place beside it, others to the objects that the demonstration did not move, or to a free site on the table.
% If there is no such site, state.hasSite stays false and problem says why.
  problem = '';
  is_dragged = arrayfun(@isDragged, state.steps);
  is_replacing = ~cellfun(@isempty, {state.steps.takesPlaceOf});
  is_returning = ~cellfun(@isempty, {state.steps.aside});
  carried = state.steps(~is_dragged & ~is_replacing & ~is_returning);
  if ~isempty(state.containers)
    [carried, found, problem] = placeInContainers(carried, state.containers, state.known, picture, eye);
    if isempty(problem), state.containers = found; end
  elseif ~isempty(carried) && ~isempty(carried(1).anchor)
    [carried, problem] = placeAtAnchor(carried, state.known, arms, eye);
  elseif ~isempty(carried)
    placed = placeByWhatStays(carried, state.known, arms, eye);
    if isempty(placed), [placed, problem] = placeOnTable(carried, state.known, arms, eye); end
    carried = placed;
  end
  steps = state.steps;
  if isempty(problem), steps(~is_dragged & ~is_replacing & ~is_returning) = carried; end
  for k = [find(is_returning), find(is_dragged | is_replacing)]
    if ~isempty(problem), break; end
    below = [];
    if is_replacing(k), below = placeBelow(steps(k), state.steps(is_returning), steps(is_returning)); end
    if is_returning(k)
      [steps(k), problem] = placeReturning(steps(k), state);
    elseif ~isempty(below)
      steps(k) = below;
    elseif is_dragged(k)
      [steps(k), problem] = placeDragged(steps(k), state.known);
    else
      [steps(k), problem] = placeOfOther(steps(k), state.steps, state.known);
    end
  end
  if isempty(problem), state.steps = steps; end
  state.hasSite = isempty(problem);
  state.meant = meantBlocks(state.steps, state.known);
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
