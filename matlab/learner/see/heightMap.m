function heights = heightMap(depth, eye)
% Returns the height above the table of the surface in each pixel, HxW [units]; 0 where there is none.
%   depth  HxW, distance along the axis of the camera [units]; 0 where there is no surface
  [column, row] = meshgrid((1:size(depth, 2)) - 0.5, (1:size(depth, 1)) - 0.5);
  K = eye.intrinsics;
  rise = eye.pose(3, 1) * (column - K(1, 3)) / K(1, 1) + eye.pose(3, 2) * (row - K(2, 3)) / K(2, 2) + ...
         eye.pose(3, 3);
  heights = eye.pose(3, 4) + depth .* rise;
  heights(depth <= 0) = 0;
end
