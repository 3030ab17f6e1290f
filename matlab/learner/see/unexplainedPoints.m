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
  points = points(~areCovered(points, known, c.unexplained_margin), :);
  if isempty(points), return; end
  hidden = hiddenGround(heights, eye);
  away = arrayfun(@(x, y) min(hypot(points(:, 1) - x, points(:, 2) - y)), hidden(:, 1), hidden(:, 2));
  hidden = hidden(away < c.unexplained_extent, :);
  points = [points; hidden(~areCovered(hidden, known, c.unexplained_margin), :)];
end
