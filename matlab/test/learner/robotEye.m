function eye = robotEye()
% Returns a camera like the robot's, tilted 56 degrees downward.
  f = 240 / tan(pi / 6);
  tilt = 56.05 * pi / 180;
  eye.intrinsics = [f, 0, 320; 0, f, 240; 0, 0, 1];
  eye.pose = [1, 0, 0, 0; 0, -sin(tilt), cos(tilt), -6.1168; 0, -cos(tilt), -sin(tilt), 11.5921; ...
              0, 0, 0, 1];
  eye.table = [20, 12];
end
