function block = measureCoveredTop(demo, n, pictures)
% Measures an object that stood on the table all the time, below another one, as a block at its first place; a 1x0 struct
% array if it is none, or no picture shows enough of its top.
%   pictures  cache, with the one of its first frame
  block = noBlocks();
  c = constants();
  rows = demo.moves(demo.moves(:, 2) == n, :);
  picture = pictures(rows(1, 1));
  start = demo.start(n, :);
  away = demo.start(:, 1:3) - start(1:3);
  is_below = away(:, 3) > 0 & hypot(away(:, 1), away(:, 2)) < c.task_model.same_place;
  if isempty(picture) || any(demo.placed == n) || ~hasShape(demo, n, 'block') || ~any(is_below), return; end
  height = 2 * start(3);
  for color = frequentColors(picture, c.perception.min_rim_pixels)
    sides = sidesAround(picture, demo.eye, color', [start(1:3), 0, 0, start(6)], height, c.task_model.min_covered_seen);
    if isempty(sides), continue; end
    block = newBlock(color', [sides, height], start(1:3), start(6) * pi / 180);
    return
  end
end
