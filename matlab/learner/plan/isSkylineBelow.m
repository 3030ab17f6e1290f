function yes = isSkylineBelow(skyline, points)
% Returns true if a skyline (see skylineOf) is below all of some points, or beside them.
%   points  Nx3 [units]
  cells = 1 + cellsOf(points, skyline.corner);
  inside = all(cells >= 1 & cells <= size(skyline.heights), 2);
  heights = skyline.heights(sub2ind(size(skyline.heights), cells(inside, 1), cells(inside, 2)));
  yes = all(heights(:) < points(inside, 3));
end
