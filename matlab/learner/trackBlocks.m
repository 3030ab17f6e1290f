function objects = trackBlocks(objects, seen, is_table, was_free)
% Tracks the objects of a demonstration from picture to picture: one update with blocks at rest. Without
% arguments: no objects yet.
%   seen      the blocks, as from fitBlocks, with the number of visible pixels of each; a block without
%             support is being held and is ignored
%   is_table  predicate: returns true if the table is visible at a block's place
%   was_free  predicate: returns true if a block's place was free in some picture before
%   objects   as blocks, and
%     start   pose where it was first seen, 1x6, as in readDemonstration
%     placed  order of its last placement: 1, 2, ...; 0 for never
  if nargin == 0
    objects = struct('color', {}, 'size', {}, 'position', {}, 'yaw', {}, 'pixels', {}, 'start', {}, ...
                     'placed', {});
    return
  end
  is_first = isempty(objects);
  is_matched = false(1, numel(objects));
  is_new = true(1, numel(seen));
  for i = 1:numel(seen)
    here = find(arrayfun(@(other) isSame(other, seen(i), 0.3), objects) & ~is_matched, 1);
    if isempty(here), continue; end
    % It may be partly occluded now.
    max_pixels = objects(here).pixels;
    if seen(i).pixels > 0.97 * max_pixels
      objects(here) = movedTo(objects(here), seen(i));
      objects(here).pixels = max(max_pixels, seen(i).pixels);
    end
    is_matched(here) = true;
    is_new(i) = false;
  end

  % The others have moved. Lower blocks come first: they support the higher ones.
  seen = seen(is_new);
  [~, order] = sort(arrayfun(@(block) block.position(3), seen));
  for block = seen(order)
    if ~hasSupport(block, objects), continue; end
    k = associatedObject(block, objects, is_matched, is_table);
    was_hidden = isempty(k) && ~was_free(block) && block.position(3) < block.size(3);
    if isempty(k)
      k = numel(objects) + 1;
      objects(k).color = block.color;
      objects(k).size = block.size;
      objects(k).start = [block.position, 0, 0, block.yaw * 180 / pi];
      objects(k).placed = 0;
    end
    objects(k) = movedTo(objects(k), block);
    if ~is_first && ~was_hidden, objects(k).placed = max([objects.placed]) + 1; end
    is_matched(k) = true;
  end
end

function k = associatedObject(block, objects, is_matched, is_table)
% Associates a block at a new place with an object; [] for one that was never seen. Covered objects cannot
% have moved. Objects whose old place shows the table come first, then the closest, which may be occluded.
  free = find(~is_matched & arrayfun(@(other) isSame(other, block, Inf), objects));
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

function yes = hasSupport(block, objects)
% Returns true if the table or an object is right below a block.
  bottom = block.position(3) - block.size(3) / 2;
  yes = bottom < constants().perception.on_table || any(arrayfun(@(object) isCovered(object, block), objects));
end

function yes = isCovered(object, others)
% Returns true if one of the others lies on an object.
  top = object.position(3) + object.size(3) / 2;
  bottoms = arrayfun(@(other) other.position(3) - other.size(3) / 2, others);
  on_top = others(abs(bottoms - top) < 0.15);
  yes = any(overlap(footprint(object, 0), footprint(on_top, 0)));
end

function object = movedTo(object, block)
  object.position = block.position;
  object.yaw = block.yaw;
  object.pixels = block.pixels;
end
