function [steps, container] = understand(demo, attention)
% What was done, as a list of steps in the order shown. Each object that takes part has one:
%   name      of the object in the demonstration, for people
%   color     by which to find it, 1x3; [] if the demonstrator told that color does not matter
%   size      its sides along its own axes, the longer one first, and its height [units]
%   position  of its centre, 1x3 [units], and
%   yaw       of its longer side [rad]; both for a building that stands where it stood in the
%             demonstration
%   on        numbers of the steps that it stands on; empty for an object on the table
%   way       by how much it was drawn along, from where it stood before, 1x2 [units]; empty for an object
%             that was carried. It is then what such an object can be drawn by that has color and size.
% The container is what objects were put into: see measureContainer.
  part = takingPart(demo);
  is_drawn = arrayfun(@(n) wasDrawn(demo, n), part);
  if isfield(demo, 'looks'), looks = demo.looks; else, looks = measureObjects(demo, part(~is_drawn)); end
  for k = 1:numel(part)
    n = part(k);
    if is_drawn(k)
      steps(k) = measureHandle(demo, n);
      continue
    end
    sides = looks(n).size;
    yaw = demo.final(n, 6) * pi / 180;
    if sides(2) > constants().blocks.equal_sides * sides(1)
      sides(1:2) = sides([2, 1]);
      yaw = yaw + pi / 2;
    end
    steps(k) = struct('name', demo.ids{n}, 'color', looks(n).color, 'size', sides, ...
                      'position', demo.final(n, 1:3), 'yaw', yaw, 'on', [], 'way', []);
    for j = 1:k - 1
      if standsOn(steps(k), steps(j)), steps(k).on(end + 1) = j; end
    end
    if ~colorMatters(attention, demo.ids{n}), steps(k).color = []; end
  end
  container = measureContainer(demo, steps);
end

function part = takingPart(demo)
% Numbers of the objects that take part, in the order of building: first what was not moved but has
% something on it, then what was, in the order in which it was let go for the last time.
  c = constants().understand;
  last = zeros(1, numel(demo.ids));
  last(demo.placed) = 1:numel(demo.placed);
  moved = find(last > 0);
  if isempty(moved), error('in this demonstration no hand moved anything'); end
  [~, order] = sort(last(moved));
  below = zeros(1, 0);
  for n = find(last == 0)
    gap = demo.final(moved, 1:3) - demo.final(n, 1:3);
    is_above = sqrt(sum(gap(:, 1:2) .^ 2, 2)) < c.carried_distance;
    if any(gap(:, 3) > c.carried_heights(1) & gap(:, 3) < c.carried_heights(2) & is_above)
      below(end + 1) = n;
    end
  end
  part = [below, moved(order)];
end

function yes = standsOn(upper, lower)
  gap = (upper.position(3) - upper.size(3) / 2) - (lower.position(3) + lower.size(3) / 2);
  yes = abs(gap) < constants().understand.standing_gap && overlap(footprint(upper, 0), footprint(lower, 0));
end

function yes = colorMatters(attention, name)
% The demonstrator may have told which properties of an object matter; who tells nothing means all.
  yes = true;
  for k = 1:numel(attention)
    if strcmp(attention(k).object, name) && ~isempty(attention(k).properties)
      yes = any(strcmp(attention(k).properties, 'color'));
    end
  end
end
