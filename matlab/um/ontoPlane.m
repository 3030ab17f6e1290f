function [x, y, area] = ontoPlane(row, column, eye, z)
% Where the table's points at height z are that these pixels show, and how large each pixel is there
% [units, units squared].
%   eye.intrinsics, eye.pose  as in aux
  p = eye.pose(1:3, 4);
  R = eye.pose(1:3, 1:3);
  K = eye.intrinsics;
  % A ray through the middle of each pixel; camera axes are x right, y down, z forward.
  ray = [(column(:)' - 0.5 - K(1, 3)) / K(1, 1); (row(:)' - 0.5 - K(2, 3)) / K(2, 2); ...
         ones(1, numel(row))];
  ray = R * ray;
  along = (z - p(3)) ./ ray(3, :);  % how far along its ray each point lies
  x = (p(1) + along .* ray(1, :))';
  y = (p(2) + along .* ray(2, :))';
  % A plane seen at an angle: far pixels are larger, by the third power of the distance.
  area = (along .^ 3)' / abs(z - p(3)) / (K(1, 1) * K(2, 2));
end
