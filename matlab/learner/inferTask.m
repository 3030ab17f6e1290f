function [steps, container] = inferTask(demo, attention)
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
% container is the open box that objects were put into: see measureContainer.
  taking_part = participatingObjects(demo);
  is_dragged = arrayfun(@(n) wasDragged(demo, n), taking_part);
  if isfield(demo, 'appearances')
    appearances = demo.appearances;
  else
    appearances = measureObjects(demo, taking_part(~is_dragged));
  end
  for k = 1:numel(taking_part)
    n = taking_part(k);
    if is_dragged(k)
      steps(k) = measureHandle(demo, n);
      continue
    end
    sides = appearances(n).size;
    yaw = demo.final(n, 6) * pi / 180;
    if sides(2) > constants().blocks.equal_sides * sides(1)
      sides(1:2) = sides([2, 1]);
      yaw = yaw + pi / 2;
    end
    steps(k) = struct('name', demo.ids{n}, 'color', appearances(n).color, 'size', sides, ...
                      'position', demo.final(n, 1:3), 'yaw', yaw, 'on', [], 'displacement', []);
    for j = 1:k - 1
      if standsOn(steps(k), steps(j)), steps(k).on(end + 1) = j; end
    end
    if ~colorMatters(attention, demo.ids{n}), steps(k).color = []; end
  end
  container = measureContainer(demo, steps);
end

function taking_part = participatingObjects(demo)
% Returns the numbers of the objects that take part, in the order of building: first the objects that
% were not moved but support others, then the moved ones, in the order of their last release.
  c = constants().task_model;
  last = zeros(1, numel(demo.ids));
  last(demo.placed) = 1:numel(demo.placed);
  moved = find(last > 0);
  if isempty(moved), error('in this demonstration no hand moved anything'); end
  [~, order] = sort(last(moved));
  below = zeros(1, 0);
  for n = find(last == 0)
    offset = demo.final(moved, 1:3) - demo.final(n, 1:3);
    is_above = sqrt(sum(offset(:, 1:2) .^ 2, 2)) < c.support_distance;
    if any(offset(:, 3) > c.support_heights(1) & offset(:, 3) < c.support_heights(2) & is_above)
      below(end + 1) = n;
    end
  end
  taking_part = [below, moved(order)];
end

function yes = standsOn(upper, lower)
% Returns true if the bottom of a step's object touches the top of another one.
  gap = (upper.position(3) - upper.size(3) / 2) - (lower.position(3) + lower.size(3) / 2);
  yes = abs(gap) < constants().task_model.max_support_gap && ...
        overlap(footprint(upper, 0), footprint(lower, 0));
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
