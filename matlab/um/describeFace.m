function face = describeFace(x, y, area, yaw)
% A rectangle in a plane, from small pieces of it.
%   x, y, area   of the pieces, Nx1 [units, units squared]
%   yaw          how its first side is turned [rad]; found by itself unless given
%   face.center  1x2
%   face.yaw     [rad]
%   face.sides   how long it is along the direction of yaw, and across, 1x2
%   face.misfit  by how much, in proportion, the pieces are less or more than such a rectangle
  total = sum(area);
  face.center = [sum(x .* area), sum(y .* area)] / total;
  x = x - face.center(1);
  y = y - face.center(2);
  if nargin < 4, yaw = yawOf(x, y, area); end
  along = x * cos(yaw) + y * sin(yaw);
  across = y * cos(yaw) - x * sin(yaw);
  % The points of a rectangle lie around its center with a variance of a twelfth of the side, squared.
  face.yaw = yaw;
  face.sides = sqrt(12 * [sum(along .^ 2 .* area), sum(across .^ 2 .* area)] / total);
  face.misfit = abs(prod(face.sides) / total - 1);
end

function yaw = yawOf(x, y, area)
% Multiplying complex numbers adds their angles. So the squares of the pieces of something long all
% point about the same way, at twice its angle.
  z = x + 1i * y;
  long = sum(area .* z .^ 2);
  spread = sum(area .* abs(z) .^ 2);
  if abs(long) > constants().see.elongated * spread
    yaw = angle(long) / 2;
  else
    % A square has no long side, but its fourth power has a direction: the corners are farthest out and
    % count most, at 0 degrees they lie at 45, and four times that is 180; hence the minus.
    yaw = angle(-sum(area .* z .^ 4)) / 4;
  end
end
