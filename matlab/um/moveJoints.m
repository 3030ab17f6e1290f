function path = moveJoints(robot, arm, waypoints)
% See smileMoveJoints; arm is 1 or 2.
  names = {'left', 'right'};
  path = smileMoveJoints(robot, names{arm}, waypoints, 'speed', constants().carry.speed);
end
