function [steps, containers, appearances] = inferTask(demo, attention, needs)
% Infers from a demonstration what is to be done: a list of steps (see newStep) in the order shown, one for each
% object that takes part, except tools that were put back. Objects that were not moved but support others, or are in them, come
% first; one that was not moved and tells where all others go comes last.
%   attention    the properties of objects that matter, if the demonstrator specified some, as in aux
%   containers   the open boxes that objects were put into: see measureContainers
%   appearances  of all objects: see measureObjects
%   needs        what the goal needs, if it is known: see needsOf
  if nargin < 3, needs = []; end
  moved = movedObjects(demo);
  is_dragged = arrayfun(@(n) wasDragged(demo, n), moved);
  if isfield(demo, 'appearances')
    appearances = demo.appearances;
  else
    appearances = measureObjects(demo, moved(~is_dragged));
  end
  needed = neededOf(moved(~ismember(moved, toolsOf(demo))), demo, needs);
  placed = noSteps();
  for n = needed
    if any(moved(is_dragged) == n)
      placed(end + 1) = measureHandle(demo, n);
    else
      placed(end + 1) = stepOf(demo, n, appearances(n), attention);
    end
  end
  others = placed([]);
  for n = setdiff(1:numel(demo.ids), needed)
    if isempty(appearances(n).size), continue; end
    others(end + 1) = stepOf(demo, n, appearances(n), attention);
    others(end).stays = true;
  end
  steps = placed;
  if ~isempty(placed), steps = setOrder([supportsOf(placed, others), placed], attention); end
  for k = 1:numel(steps)
    bottom = steps(k).position(3) - steps(k).size(3) / 2;
    is_held = isempty(steps(k).on) && bottom > constants().task_model.min_inside_bottom && ~isDragged(steps(k));
    if is_held, steps(k).takesPlaceOf = formerOwner(demo, steps(k)); end
  end
  for k = find(~[steps.stays])
    steps(k).aside = asideOf(demo, steps(k), appearances);
    if ~isempty(needs)
      steps(k).after = union(steps(k).after, requiredBefore(needs, steps, k));
    elseif ~isempty(steps(k).aside)
      steps(k).after = setdiff(1:k - 1, steps(k).on);
    end
  end
  for k = 1:numel(steps)
    steps(k).beganOn = startSupport(demo, find(strcmp(demo.ids, steps(k).name)), steps(k), appearances);
  end
  containers = measureContainers(demo, steps(cellfun(@isempty, {steps.aside})));
  if isempty(containers), steps = withAnchor(demo, steps, others); end
end

function found = supportsOf(steps, others)
% Returns those of some other steps on which steps stand at the end, directly or on others, or which are in a ring or the like,
% the lowest first.
  is_found = false(1, numel(others));
  while ~isempty(steps)
    is_below = false(1, numel(others));
    for k = find(~is_found), is_below(k) = any(arrayfun(@(step) isPlacedBy(step, others(k)), steps)); end
    steps = others(is_below);
    is_found = is_found | is_below;
  end
  found = others(is_found);
  [~, order] = sort(arrayfun(@(step) step.position(3), found));
  found = found(order);
end
