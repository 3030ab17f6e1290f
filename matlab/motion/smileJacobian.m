function jacobian = smileJacobian(robot, arm, q)
%SMILEJACOBIAN  Velocity of an arm's tool per joint velocity.
%
%   jacobian = smileJacobian(robot, arm, q)
%
%   q         1x7 angles [rad]; Nx7 for several configurations
%   jacobian  6x7: rows 1 to 3 the velocity along x y z of the world [units/s per rad/s], rows 4 to 6
%             the angular velocity about x y z; 6x7xN for the rows of q
  jacobian = smilemotion('smileJacobian', robot, arm, q);
end
