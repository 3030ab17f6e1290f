function [x, y, area] = ontoPlane(row, column, eye, z)
% Projects pixels onto the horizontal plane at height z, or each onto that of its own height, Nx1 [units].
% Returns their points and the area that each pixel covers there, Nx1 [units, units squared].
%   eye.intrinsics, eye.pose  as in aux
  p = eye.pose(1:3, 4);
  R = eye.pose(1:3, 1:3);
  K = eye.intrinsics;
  % Rays through the pixel centers; camera axes are x right, y down, z forward.
  ray = [(column(:)' - 0.5 - K(1, 3)) / K(1, 1); (row(:)' - 0.5 - K(2, 3)) / K(2, 2); ...
         ones(1, numel(row))];
  ray = R * ray;
  down = z(:)' - p(3);
  along = down ./ ray(3, :);  % depth of each point along its ray
  x = (p(1) + along .* ray(1, :))';
  y = (p(2) + along .* ray(2, :))';
  % On an oblique plane, the area of a pixel grows with the third power of its depth.
  area = (along .^ 3 ./ abs(down))' / (K(1, 1) * K(2, 2));
end
