function verdicts = verdictsOn(known, seen, picture, eye, heights, tolerance)
% Returns a verdict of a picture on each of the known blocks, a 1xN struct array. A block whose top is partly
% hidden cannot be measured: it counts as hidden.
%   seen       the blocks detected in the picture
%   heights    see heightMap; []: a block is contradicted only where the table is visible
%   tolerance  of positions [units]
%   verdicts.word      'as expected', 'hidden', or 'contradicted'
%   verdicts.expected  the block
%   verdicts.found     number of the seen block that is in its place; [] for none
  c = constants().beliefs;
  max_yaw = constants().blocks.yaw_tolerance_rad;
  table = tableColor(picture);
  verdicts = struct('word', {}, 'expected', {}, 'found', {});
  for block = known
    word = 'contradicted';
    distances = arrayfun(@(other) norm(other.position - block.position), seen);
    distances(~arrayfun(@(other) mayReplace(other, block), seen)) = Inf;
    [distance, nearest] = min(distances);
    if ~isempty(distance) && distance < c.same_block_distance
      it = seen(nearest);
      if isSameKind(it, block)
        if distance < c.half_hidden_distance && isTopHidden(it, seen, eye)
          word = 'hidden';
        elseif distance < tolerance && abs(yawDifference(block, it.yaw)) < max_yaw
          word = 'as expected';
        end
      end
    else
      nearest = [];
      if isempty(heights)
        is_gone = isTableVisible(picture, eye, block, table);
      else
        is_gone = isRefuted(block, picture, heights, eye);
      end
      if ~is_gone, word = 'hidden'; end
    end
    verdicts(end + 1) = struct('word', word, 'expected', block, 'found', nearest);
  end
end

function yes = mayReplace(found, block)
% Returns true if what is seen there may be in the place of a block. What is entirely below or above it is another block, and so
% may be what is in a ring, or beside an L.
  is_level = abs(found.position(3) - block.position(3)) < found.size(3) / 2;
  yes = is_level && (isempty(block.outline) || isSameKind(found, block));
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
