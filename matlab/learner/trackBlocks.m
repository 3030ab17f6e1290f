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
    here = find(arrayfun(@(other) isSameObject(other, seen(i), 0.3), objects) & ~is_matched, 1);
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

function yes = hasSupport(block, objects)
% Returns true if the table or an object is right below a block.
  bottom = block.position(3) - block.size(3) / 2;
  yes = bottom < constants().perception.on_table || any(arrayfun(@(object) isCovered(object, block), objects));
end

function object = movedTo(object, block)
  object.position = block.position;
  object.yaw = block.yaw;
  object.pixels = block.pixels;
end
