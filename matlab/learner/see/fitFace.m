function face = fitFace(x, y, area, yaw)
% Fits a rectangle or a disc in a plane to small pieces of it, by their moments.
%   x, y, area   of the pieces, Nx1 [units, units squared]
%   yaw          of its first side [rad]; estimated if missing
%   face.center  1x2 [units]
%   face.yaw     [rad]
%   face.sides   length along the direction of yaw, and across it, 1x2 [units]
%   face.misfit  relative difference between the area of the pieces and that of the face
%   face.isRound true for a disc, whose sides are its diameter, twice
  total = sum(area);
  face.center = [sum(x .* area), sum(y .* area)] / total;
  x = x - face.center(1);
  y = y - face.center(2);
  if nargin < 4, yaw = yawOf(x, y, area); end
  along = x * cos(yaw) + y * sin(yaw);
  across = y * cos(yaw) - x * sin(yaw);
  variances = [sum(along .^ 2 .* area), sum(across .^ 2 .* area)] / total;
  face.yaw = yaw;
  face.isRound = hasNoDirection(x, y, area);
  if face.isRound
    % The variance of the points of a disc along a line is the diameter squared, divided by 16.
    face.sides = sqrt(16 * variances);
    face.misfit = abs(pi / 4 * prod(face.sides) / total - 1);
  else
    % The variance of the points of a rectangle along a side is the side squared, divided by 12.
    face.sides = sqrt(12 * variances);
    face.misfit = abs(prod(face.sides) / total - 1);
  end
end

function yes = hasNoDirection(x, y, area)
% Returns true if neither the squares nor the fourth powers of points around the origin have a direction, as
% complex numbers: see yawOf. Of a square, the fourth powers keep 3/7 of it.
  z = x + 1i * y;
  yes = true;
  for power = [2, 4]
    spread = sum(area .* abs(z) .^ power);
    yes = yes && abs(sum(area .* z .^ power)) < constants().perception.round * spread;
  end
end

function yaw = yawOf(x, y, area)
% Estimates the yaw of a rectangle around the origin [rad]. Multiplying complex numbers adds their angles:
% the squares of the points of an elongated rectangle point about the same way, at twice its yaw.
  z = x + 1i * y;
  direction = sum(area .* z .^ 2);
  spread = sum(area .* abs(z) .^ 2);
  if abs(direction) > constants().perception.elongated * spread
    yaw = angle(direction) / 2;
  else
    % A square has no long side; its fourth powers have a direction. The corners are farthest out and
    % weigh most; at yaw 0 they lie at 45 degrees, and four times that is 180, hence the minus.
    yaw = angle(-sum(area .* z .^ 4)) / 4;
  end
end
