function found = detectLayouts(picture, eye, like, heights)
% Detects the things of several colors in a picture whose parts (see measureParts) are those of given blocks or steps, on
% level ground, at any place and height: a 1xN struct array, see newBlock.
%   heights  as from heightMap
  found = noBlocks();
  kinds = noBlocks();
  for it = asBlocks(like)
    if ~any(arrayfun(@(kind) isSameKind(it, kind), kinds)), kinds(end + 1) = it; end
  end
  for kind = kinds
    sizes = vertcat(kind.parts.size);
    [~, largest] = max(prod(sizes(:, 1:2), 2));
    key = kind.parts(largest);
    for face = facesOf(key, picture, eye, heights)
      % A rectangle looks the same after half a turn; the other parts tell.
      for yaw = face.yaw + [0, pi]
        block = thingAt(kind, key, face.center, face.top, yaw - key.yaw);
        if all(arrayfun(@(part) isPartVisible(block, part, picture, eye, heights), kind.parts))
          found(end + 1) = block;
          break
        end
      end
    end
  end
end

function faces = facesOf(part, picture, eye, heights)
% Returns the faces in a picture that have the color and the sides of a part, turned as it is, and their heights `top`.
  c = constants().perception;
  faces = struct('center', {}, 'yaw', {}, 'isRound', {}, 'sides', {}, 'misfit', {}, 'top', {});
  number = labelRegions(colorMask(picture, part.color), heights);
  for region = find(accumarray(number(number > 0), 1) >= c.min_top_pixels)'
    pixels = find(number == region);
    if ~isLevel(heights(pixels)), continue; end
    [row, column] = ind2sub(size(number), pixels);
    top = median(heights(pixels));
    [x, y, area] = ontoPlane(row, column, eye, top);
    face = fitFace(x, y, area);
    % The longer side of a face comes first.
    if part.size(1) < part.size(2), face = fitFace(x, y, area, face.yaw - pi / 2); end
    face.top = top;
    is_like = max(abs(face.sides ./ part.size(1:2) - 1)) < c.max_side_error;
    if is_like && face.misfit < c.misfit && ~face.isRound, faces(end + 1) = face; end
  end
end

function block = thingAt(kind, part, center, top, yaw)
% Returns a thing of a kind as a block, with a part of it whose top is at a place and a height.
  block = kind;
  z = top - part.position(3);
  % The table's height is known better than that of the part.
  if abs(z - kind.size(3) / 2) < constants().perception.on_table, z = kind.size(3) / 2; end
  block.position = [center - rotated(part.position(1:2), yaw), z];
  block.yaw = yaw;
end

function yes = isPartVisible(block, part, picture, eye, heights)
% Returns true if the eye sees the color of a part of a thing where it should be.
  top = block.position(3) + part.position(3);
  [color, pixel] = colorAt(picture, eye, [block.position(1:2) + rotated(part.position(1:2), block.yaw), top]);
  yes = ~isempty(color) && sameColor(part.color, color) && ...
        abs(heights(pixel(2), pixel(1)) - top) < constants().parts.max_height_error;
end
