function pose = smileForward(robot, arm, q)
%SMILEFORWARD  Pose of an arm's tool at given joint angles.
%
%   pose = smileForward(robot, arm, q)
%
%   robot  from smileRobot
%   arm    its name
%   q      1x7 angles [rad]
%   pose   4x4, of the tool in the world [units]: z is the approach direction, y goes across the
%          fingers
  pose = smilemotion('smileForward', robot, arm, q);
end
