function face = smallestRectangle(x, y, pixel, yaw)
% Returns the rectangle of the smallest area around points, the longer side first if it has to be found: center,
% yaw and sides as from fitFace. Hidden corners do not change it, as long as each side has visible points.
%   x, y   Nx1 [units]
%   pixel  side of the small square that each point stands for [units]
%   yaw    of its first side, if it is known [rad]
  yaws = 0:constants().perception.rectangle_yaw_step_rad:pi / 2;
  if nargin == 4, yaws = yaw; end
  % A row for each point, a column for each yaw.
  along = x * cos(yaws) + y * sin(yaws);
  across = y * cos(yaws) - x * sin(yaws);
  low = [min(along, [], 1); min(across, [], 1)];
  high = [max(along, [], 1); max(across, [], 1)];
  sides = high - low + pixel;
  [~, best] = min(prod(sides, 1));
  face.center = rotated((low(:, best) + high(:, best))' / 2, yaws(best));
  face.yaw = yaws(best);
  face.sides = sides(:, best)';
  if nargin < 4 && face.sides(2) > face.sides(1)
    face.yaw = face.yaw + pi / 2;
    face.sides = face.sides([2, 1]);
  end
end
