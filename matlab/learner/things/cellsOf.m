function cells = cellsOf(points, corner)
% Returns row and column of the cells of a skyline in which points are, Nx2, from 0 on.
%   corner  x y of the corner of the first cell, 1x2 [units]
  cells = floor((points(:, 1:2) - corner) / constants().skyline.cell);
end
