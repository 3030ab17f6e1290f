function [steps, container, appearances] = inferTask(demo, attention)
% Infers from a demonstration what is to be done: a list of steps in the order shown, one for each object
% that takes part.
%   name      of the object in the demonstration, for messages
%   color     by which to detect it, 1x3; [] if the demonstrator specified that color does not matter
%   size      its sides along its own axes, the longer one first, and its height [units]
%   position  of its center, 1x3 [units], and
%   yaw       of its longer side [rad]; both for a building at the same place as in the demonstration
%   on        numbers of the steps that it stands on; empty for an object on the table
%   displacement  by which it was dragged, 1x2 [units]; empty for an object that was carried. Color and
%             size of a dragged object are those of its handle.
%   stays     true for an object that the demonstration did not move
%   isRound   true for a disc or a ball: its sides are its diameter
% Objects that were not moved but support others come first.
% container is the open box that objects were put into: see measureContainer; appearances, of all objects: see
% measureObjects.
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
  steps = [supportsOf(placed, others), placed];
  for k = 1:numel(steps)
    for j = 1:k - 1
      if standsOn(steps(k), steps(j)), steps(k).on(end + 1) = j; end
    end
  end
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

function step = stepOf(demo, n, appearance, attention)
% Returns the step of a carried object, at its final place.
  [sides, yaw] = restingAt(appearance, demo.final(n, :));
  if sides(2) > constants().blocks.equal_sides * sides(1)
    sides(1:2) = sides([2, 1]);
    yaw = yaw + pi / 2;
  end
  color = appearance.color;
  if ~colorMatters(attention, demo.ids{n}), color = []; end
  step = struct('name', demo.ids{n}, 'color', color, 'size', sides, 'position', demo.final(n, 1:3), ...
                'yaw', yaw, 'on', [], 'displacement', [], 'stays', false, ...
                'isRound', isfield(appearance, 'isRound') && appearance.isRound);
end

function yes = colorMatters(attention, name)
% Returns true unless the demonstrator specified the properties of an object that matter, without color.
  yes = true;
  for k = 1:numel(attention)
    if strcmp(attention(k).object, name) && ~isempty(attention(k).properties)
      yes = any(strcmp(attention(k).properties, 'color'));
    end
  end
end
