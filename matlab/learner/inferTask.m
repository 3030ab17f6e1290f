function [steps, container, appearances] = inferTask(demo, attention)
% Infers from a demonstration what is to be done: a list of steps (see newStep) in the order shown, one for each
% object that takes part. Objects that were not moved but support others come first.
%   attention    the properties of objects that matter, if the demonstrator specified some, as in aux
%   container    the open box that objects were put into: see measureContainer
%   appearances  of all objects: see measureObjects
  moved = movedObjects(demo);
  is_dragged = arrayfun(@(n) wasDragged(demo, n), moved);
  if isfield(demo, 'appearances')
    appearances = demo.appearances;
  else
    appearances = measureObjects(demo, moved(~is_dragged));
  end
  for k = 1:numel(moved)
    if is_dragged(k)
      placed(k) = measureHandle(demo, moved(k));
    else
      placed(k) = stepOf(demo, moved(k), appearances(moved(k)), attention);
    end
  end
  others = placed([]);
  for n = setdiff(1:numel(demo.ids), moved)
    if isempty(appearances(n).size), continue; end
    others(end + 1) = stepOf(demo, n, appearances(n), attention);
    others(end).stays = true;
  end
  steps = setOrder([supportsOf(placed, others), placed], attention);
  container = measureContainer(demo, steps);
end

function moved = movedObjects(demo)
% Returns the numbers of the objects that hands moved, in the order of their last release.
  last = zeros(1, numel(demo.ids));
  last(demo.placed) = 1:numel(demo.placed);
  moved = find(last > 0);
  if isempty(moved), error('in this demonstration no hand moved anything'); end
  [~, order] = sort(last(moved));
  moved = moved(order);
end

function found = supportsOf(steps, others)
% Returns those of some other steps on which steps stand at the end, directly or on others, the lowest first.
  is_found = false(1, numel(others));
  while ~isempty(steps)
    is_below = false(1, numel(others));
    for k = find(~is_found), is_below(k) = any(arrayfun(@(step) standsOn(step, others(k)), steps)); end
    steps = others(is_below);
    is_found = is_found | is_below;
  end
  found = others(is_found);
  [~, order] = sort(arrayfun(@(step) step.position(3), found));
  found = found(order);
end
