function pose = toolPose(arm, point, across, opening)
% Returns the pose of an arm's tool, 4x4 as in smileForward, with the fingers straight down on both sides of
% a point, 1x3 [units].
%   across   direction from finger to finger, seen from above [rad]
%   opening  of the fingers [units]
  c = cos(across);
  s = sin(across);
  middle = 0;
  if arm.opening > 0, middle = smileGripperMiddle(arm.robot, arm.name, opening); end
  pose = [-s, c, 0, point(1) - c * middle
          c, s, 0, point(2) - s * middle
          0, 0, -1, point(3)
          0, 0, 0, 1];
end
