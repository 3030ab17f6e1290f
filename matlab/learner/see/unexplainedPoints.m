function points = unexplainedPoints(known, heights, eye)
% Returns points of visible surfaces above the table that belong to none of the known blocks, and points of the
% table around them that are hidden: something is there, like a plate below a tower. Nx2 [units]. What hangs
% higher, like arms, is left out.
%   heights  as from heightMap
  c = constants().perception;
  step = c.unexplained_pixel_step;
  part = heights(1:step:end, 1:step:end);
  [row, column] = find(part > c.on_table & part < c.unexplained_below);
  z = part(sub2ind(size(part), row, column));
  [x, y] = ontoPlane(1 + step * (row - 1), 1 + step * (column - 1), eye, z);
  % One point for all that are close together.
  points = unique(round([x, y] / c.unexplained_spacing), 'rows') * c.unexplained_spacing;
  if isempty(points), return; end
  points = points(~isWithin(points, known, c.unexplained_margin), :);
  if isempty(points), return; end
  hidden = hiddenGround(heights, eye);
  away = arrayfun(@(x, y) min(hypot(points(:, 1) - x, points(:, 2) - y)), hidden(:, 1), hidden(:, 2));
  hidden = hidden(away < c.unexplained_extent, :);
  points = [points; hidden(~isWithin(hidden, known, c.unexplained_margin), :)];
end

function hidden = hiddenGround(heights, eye)
% Returns the points of the table, in a grid, at which the eye sees something higher: Nx2 [units].
  c = constants().task_planning;
  [y, x] = ndgrid(nearEdge(eye) + (c.place_depth(1):c.place_depth(2):c.place_depth(3)), ...
                  c.place_x(1):c.place_x(2):c.place_x(3));
  hidden = [x(:), y(:)];
  pixels = pixelAt([hidden, zeros(numel(x), 1)], eye);
  inside = all(pixels >= 1 & pixels <= [size(heights, 2), size(heights, 1)], 2);
  hidden = hidden(inside, :);
  pixels = pixels(inside, :);
  hidden = hidden(heights(sub2ind(size(heights), pixels(:, 2), pixels(:, 1))) > constants().perception.on_table, :);
end

function yes = isWithin(points, blocks, margin)
% Returns which of N points are in the areas of some blocks, with a margin [units]: Nx1 logical.
  yes = any(overlap([points, zeros(rows(points), 3)], footprint(blocks, margin)), 1)';
end
