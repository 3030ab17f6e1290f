function pose = smileForward(robot, arm, q)
%SMILEFORWARD  Pose of an arm's tool at given joint angles.
%
%   pose = smileForward(robot, arm, q)
%
%   robot  from smileRobot
%   arm    its name
%   q      1x7 angles [rad]; Nx7 for several configurations
%   pose   4x4, of the tool in the world [units]: z is the approach direction, y goes across the
%          fingers; 4x4xN for the rows of q
  pose = smilemotion('smileForward', robot, arm, q);
end
