function pose = toolPose(point, across)
% The tool, fingers straight down, at a point, 1x3 [units]; across is the direction from finger to
% finger, seen from above [rad]. 4x4, as in smileForward.
  c = cos(across);
  s = sin(across);
  pose = [-s, c, 0, point(1)
          c, s, 0, point(2)
          0, 0, -1, point(3)
          0, 0, 0, 1];
end
