function surface = surfaceOf(picture, heights, eye)
% Returns what a picture shows above the table: a point for each pixel, row by row.
%   heights         as from heightMap
%   surface.points  Nx3 [units]
%   surface.colors  Nx3
  [column, row] = find(heights' > constants().alignment.min_height);
  pixels = sub2ind(size(heights), row, column);
  z = heights(pixels);
  [x, y] = ontoPlane(row, column, eye, z);
  colors = reshape(picture, [], 3);
  surface = struct('points', [x, y, z], 'colors', colors(pixels, :));
end
