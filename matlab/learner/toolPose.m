function pose = toolPose(point, across)
% Returns the pose of the tool, 4x4 as in smileForward, with the fingers straight down at a point, 1x3
% [units].
%   across  direction from finger to finger, seen from above [rad]
  c = cos(across);
  s = sin(across);
  pose = [-s, c, 0, point(1)
          c, s, 0, point(2)
          0, 0, -1, point(3)
          0, 0, 0, 1];
end
