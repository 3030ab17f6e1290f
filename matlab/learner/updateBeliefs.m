function now = updateBeliefs(known, seen, picture, eye, heights)
% Returns the known blocks after an observation: those seen, and those that were known before and may be
% occluded now. A block whose top is partly hidden cannot be measured again: it is where it was known to be.
% Without heights, as from heightMap, a block is forgotten where the table is visible.
  if nargin < 5, heights = []; end
  c = constants().beliefs;
  table = tableColor(picture);
  now = seen;
  for block = known
    % What is entirely below or above it is another block.
    distances = arrayfun(@(other) norm(other.position - block.position), seen);
    apart = arrayfun(@(other) abs(other.position(3) - block.position(3)) >= other.size(3) / 2, seen);
    distances(apart) = Inf;
    [distance, nearest] = min(distances);
    if ~isempty(distance) && distance < c.same_block_distance
      if isSameKind(seen(nearest), block) && distance < c.half_hidden_distance && ...
         isTopHidden(seen(nearest), seen, eye)
        now(nearest) = block;
      end
      continue
    end
    if isempty(heights)
      is_gone = isTableVisible(picture, eye, block, table);
    else
      is_gone = isRefuted(block, picture, heights, eye);
    end
    if ~is_gone, now(end + 1) = block; end
  end
end

function yes = isRefuted(block, picture, heights, eye)
% Returns true if a block cannot be where it was known to be: at some point of its top, the eye sees
% something lower, or in its middle something of another color at the same height, and its own color nowhere.
% What hides a point is higher: lines of sight descend.
  step = constants().perception.height_step;
  points = topPoints(block);
  is_lower = false;
  is_level = false(1, size(points, 1));
  has_color = is_level;
  for k = 1:size(points, 1)
    [color, pixel] = colorAt(picture, eye, points(k, :));
    if isempty(color), continue; end
    above = heights(pixel(2), pixel(1)) - points(k, 3);
    is_lower = is_lower || above < -step;
    is_level(k) = above < step;
    has_color(k) = sameColor(block.color, color);
  end
  yes = is_lower || (is_level(1) && ~any(is_level & has_color));
end
