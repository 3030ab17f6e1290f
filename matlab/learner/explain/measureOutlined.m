function block = measureOutlined(demo, n, frames, pictures)
% Measures an object by its top in two pictures that show it at different places, as a block at its first place; a 1x0 struct array if
% no two do. Around the first, only the table and the object's own sides may be visible, and both must show the same outline.
%   frames    as from selectFrames
%   pictures  of these frames
  block = noBlocks();
  if ~any(demo.placed == n), return; end
  height = 2 * min(demo.moves(demo.moves(:, 2) == n, 5));
  for row = frames'
    elsewhere = frames(max(abs(frames(:, 2:4) - row(2:4)'), [], 2) > constants().outlines.min_distance, :);
    for top = topsAt(pictures(row(1)), demo.eye, row(2:7)', height, true)
      outline = outlineOf(top.x, top.y, top.area);
      if ~isSeenAt(outline, top.color, elsewhere, height, demo.eye, pictures), continue; end
      pixel = sqrt(median(top.area));
      sides = 2 * max(abs([top.x, top.y])) + pixel;
      block = newBlock(top.color, [sides, height], demo.start(n, 1:3), demo.start(n, 6) * pi / 180);
      block.outline = outline;
      block.outline.inside = pointsInside(top.x, top.y);
      grips = gripsOf(top.x, top.y, pixel, top.color, height);
      block.knob = grips(1:min(1, end));
      block.otherKnobs = grips(2:end);
      return
    end
  end
end

function yes = isSeenAt(outline, color, frames, height, eye, pictures)
% Returns true if one of some pictures shows an outline of a color at its place.
  yes = false;
  for row = frames'
    for top = topsAt(pictures(row(1)), eye, row(2:7)', height, false)
      yes = sameColor(color, top.color) && sameOutline(outline, outlineOf(top.x, top.y, top.area));
      if yes, return; end
    end
  end
end

function tops = topsAt(picture, eye, pose, height, is_alone)
% Returns what may be the top of an upright object at a pose, a 1xN struct array: color; x and y in its frame and area of the pixels.
%   is_alone  whether only the table and its own sides may be visible around it
  tops = struct('x', {}, 'y', {}, 'area', {}, 'color', {});
  c = constants();
  if isempty(picture), return; end
  [~, middle] = colorAt(picture, eye, pose(1:3));
  table = tableColor(picture);
  flat = reshape(picture, [], 3);
  for color = frequentColors(picture, c.perception.min_rim_pixels)
    is_table = max(abs(color' - table)) < c.perception.table_tolerance;
    if is_table || ~isColorNear(picture, color', middle), continue; end
    number = labelRegions(colorMask(picture, color'));
    for region = find(accumarray(number(number > 0), 1) >= c.perception.min_rim_pixels)'
      pixels = find(number == region);
      [row, column] = ind2sub(size(number), pixels);
      [x, y, area] = ontoPlane(row, column, eye, pose(3) + height / 2);
      at = rotated([x, y] - pose(1:2), -pose(6) * pi / 180);
      if min(hypot(at(:, 1), at(:, 2))) >= c.outlines.max_distance, continue; end
      if is_alone && ~standsAlone(picture, number == region, color', table), continue; end
      tops(end + 1) = struct('x', at(:, 1), 'y', at(:, 2), 'area', area, 'color', median(flat(pixels, :), 1));
    end
  end
end

function yes = standsAlone(picture, mask, color, table)
% Returns true if, around a top of a color, only the table and darker shades of the color are visible.
  c = constants();
  around = false(size(mask) + 2);
  around(2:end - 1, 2:end - 1) = mask;
  for axis = [1, 2], around = around | circshift(around, 1, axis) | circshift(around, -1, axis); end
  flat = reshape(picture, [], 3);
  beside = flat(around(2:end - 1, 2:end - 1) & ~mask, :);
  own = max(abs(beside - table), [], 2) < c.perception.table_tolerance | isDarkerShade(beside, color);
  yes = mean(own) > c.outlines.min_alone;
end
