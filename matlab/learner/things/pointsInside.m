function points = pointsInside(x, y)
% Returns some points, Nx2, that are well inside a shape: of the cells that its points fill, some of those with all neighbors
% filled, if there are any.
%   x, y  points of the shape, Nx1 [units]
  c = constants().outlines;
  cells = unique(floor([x, y] / c.cell), 'rows');
  is_inner = true(rows(cells), 1);
  for step = [-1, -1, -1, 0, 0, 1, 1, 1; -1, 0, 1, -1, 1, -1, 0, 1]
    is_inner = is_inner & ismember(cells + step', cells, 'rows');
  end
  if any(is_inner), cells = cells(is_inner, :); end
  points = (cells(1 + floor(c.fractions(:) * (rows(cells) - 1) + 0.5), :) + 0.5) * c.cell;
end
