function skyline = skylineOf(points)
% Returns the skyline of visible points, Nx3 [units]: how high what the eye sees rises above each place of the table. What lies
% below is taken to be filled.
%   skyline.heights  of the highest visible point in each square cell of a grid, rows along x [units]; 0 where nothing is seen
%   skyline.corner   x y of the corner of the first cell, 1x2 [units]
  skyline = struct('heights', zeros(0, 0), 'corner', [0, 0]);
  if isempty(points), return; end
  skyline.corner = min(points(:, 1:2), [], 1);
  skyline.heights = accumarray(1 + cellsOf(points, skyline.corner), points(:, 3), [], @max);
end
