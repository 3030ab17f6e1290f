function objects = trackBlocks(objects, seen, is_table, was_free)
% The objects of a demonstration, after one more look at blocks at rest.
%   seen      the blocks, as from fitBlocks, and how many pixels of each are seen; one that lies on nothing
%             is being held and left out
%   is_table  tells of a block whether the table is seen at its place
%   was_free  tells of a block whether nothing was seen at its place before
%   objects   as blocks, and
%     start   where it was first seen, 1x6, as in readDemonstration
%     placed  when it was put where it is: a number that grows from one to the next; 0 for never
% Without arguments: no objects yet.
  if nargin == 0
    objects = struct('color', {}, 'size', {}, 'position', {}, 'yaw', {}, 'pixels', {}, 'start', {}, 'placed', {});
    return
  end
  is_first = isempty(objects);
  is_met = false(1, numel(objects));
  is_new = true(1, numel(seen));
  for i = 1:numel(seen)
    here = find(arrayfun(@(other) isSame(other, seen(i), 0.3), objects) & ~is_met, 1);
    if isempty(here), continue; end
    % Something may hide a part of it by now.
    most = objects(here).pixels;
    if seen(i).pixels > 0.97 * most
      objects(here) = at(objects(here), seen(i));
      objects(here).pixels = max(most, seen(i).pixels);
    end
    is_met(here) = true;
    is_new(i) = false;
  end

  % The rest is elsewhere than before. What is below comes first: it carries the others.
  seen = seen(is_new);
  [~, order] = sort(arrayfun(@(block) block.position(3), seen));
  for block = seen(order)
    if ~isHeldUp(block, objects), continue; end
    k = whichOne(block, objects, is_met, is_table);
    was_hidden = isempty(k) && ~was_free(block) && block.position(3) < block.size(3);
    if isempty(k)
      k = numel(objects) + 1;
      objects(k).color = block.color;
      objects(k).size = block.size;
      objects(k).start = [block.position, 0, 0, block.yaw * 180 / pi];
      objects(k).placed = 0;
    end
    objects(k) = at(objects(k), block);
    if ~is_first && ~was_hidden, objects(k).placed = max([objects.placed]) + 1; end
    is_met(k) = true;
  end
end

function k = whichOne(block, objects, is_met, is_table)
% The object that a block is which was not there before; [] for one that was never seen. Nobody takes an
% object from below another one. Where the table shows it has gone; else the nearest may be hidden.
  free = find(~is_met & arrayfun(@(other) isSame(other, block, Inf), objects));
  free = free(arrayfun(@(k) ~isCovered(objects(k), objects), free));
  gone = free(arrayfun(@(k) is_table(objects(k)), free));
  if ~isempty(gone), free = gone; end
  [~, nearest] = min(arrayfun(@(k) norm(objects(k).position - block.position), free));
  k = free(nearest);
end

function yes = isSame(object, block, near)
  yes = sameColor(object.color, block.color) && sameSize(object.size, block.size) && ...
        norm(object.position - block.position) < near;
end

function yes = isHeldUp(block, objects)
% By the table, or by an object below it.
  bottom = block.position(3) - block.size(3) / 2;
  yes = bottom < constants().see.on_table || any(arrayfun(@(object) isCovered(object, block), objects));
end

function yes = isCovered(object, others)
% Whether one of the others lies on an object.
  top = object.position(3) + object.size(3) / 2;
  bottoms = arrayfun(@(other) other.position(3) - other.size(3) / 2, others);
  on_top = others(abs(bottoms - top) < 0.15);
  yes = any(overlap(footprint(object, 0), footprint(on_top, 0)));
end

function object = at(object, block)
  object.position = block.position;
  object.yaw = block.yaw;
  object.pixels = block.pixels;
end
