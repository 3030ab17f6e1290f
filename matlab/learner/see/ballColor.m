function color = ballColor(picture, eye, center, radius)
% Returns the color of a ball, 1x3, where it faces the eye, if a picture shows it entirely and nothing of its
% color around it; otherwise [].
%   center  1x3 [units]
  c = constants().balls;
  toward = eye.pose(1:3, 4)' - center;
  color = colorAt(picture, eye, center + radius * toward / norm(toward));
  if isempty(color), return; end
  mask = shadeMask(picture, color);
  away = rayDistances(size(mask), eye, center) / radius;
  around = c.around(1) < away & away < c.around(2);
  is_whole = mean(mask(away < c.within)) > c.min_inside && mean(mask(around)) < c.max_around;
  if ~is_whole, color = []; end
end

function distances = rayDistances(shape, eye, point)
% Returns the distance of a point, 1x3, from the ray through each pixel, HxW [units].
  persistent rays;  % of the last eye: unit vectors
  persistent of;
  if ~isequal(of, {shape, eye})
    [column, row] = meshgrid((1:shape(2)) - 0.5, (1:shape(1)) - 0.5);
    K = eye.intrinsics;
    rays = [(column(:) - K(1, 3)) / K(1, 1), (row(:) - K(2, 3)) / K(2, 2), ones(numel(row), 1)] * ...
           eye.pose(1:3, 1:3)';
    rays = rays ./ sqrt(sum(rays .^ 2, 2));
    of = {shape, eye};
  end
  to_point = point - eye.pose(1:3, 4)';
  distances = reshape(sqrt(max(sum(to_point .^ 2) - (rays * to_point') .^ 2, 0)), shape);
end
