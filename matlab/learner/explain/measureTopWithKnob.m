function block = measureTopWithKnob(demo, n, frames, pictures)
% Measures an object with a part in the middle of its top, like a lid with a knob, as a block at its first place;
% a 1x0 struct array if no picture shows the rest of its top. Its height is twice that of its middle where a hand
% put it lowest, on the table.
%   frames    as from selectFrames in measureObjects
%   pictures  of these frames
  block = noBlocks();
  if ~any(demo.placed == n), return; end
  height = 2 * min(demo.moves(demo.moves(:, 2) == n, 5));
  for row = frames'
    picture = pictures(row(1));
    if isempty(picture), continue; end
    for color = frequentColors(picture, constants().perception.min_rim_pixels)
      sides = sidesAround(picture, demo.eye, color', row(2:7)', height);
      if isempty(sides), continue; end
      block = newBlock(color', [sides, height], demo.start(n, 1:3), demo.start(n, 6) * pi / 180);
      block.hasKnob = true;
      return
    end
  end
end

function sides = sidesAround(picture, eye, color, pose, height)
% Returns the sides of a top of a color at a pose, if most of it, but not its middle, is visible; otherwise [].
  sides = [];
  c = constants();
  top = pose(1:3) + [0, 0, height / 2];
  [~, pixel] = colorAt(picture, eye, top);
  if ~isColorNear(picture, color, pixel), return; end
  number = labelRegions(colorMask(picture, color));
  for region = find(accumarray(number(number > 0), 1) >= c.perception.min_rim_pixels)'
    if number(pixel(2), pixel(1)) == region, continue; end
    [row, column] = find(number == region);
    [x, y, area] = ontoPlane(row, column, eye, top(3));
    face = smallestRectangle(x, y, sqrt(median(area)), pose(6) * pi / 180);
    if norm(face.center - top(1:2)) < c.task_model.max_container_error && ...
       sum(area) > c.task_model.min_top_seen * prod(face.sides)
      sides = face.sides;
      return
    end
  end
end
