function path = moveJoints(robot, arm, waypoints)
% Plans a path through joint waypoints, Nx7 [rad]: see smileMoveJoints. arm is 1 or 2.
  names = {'left', 'right'};
  path = smileMoveJoints(robot, names{arm}, waypoints, 'speed', constants().motion_planning.speed);
end
