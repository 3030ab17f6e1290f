function q = smileInverse(robot, arm, goal, qStart, varargin)
%SMILEINVERSE  Joint angles that put an arm's tool at a pose.
%
%   q = smileInverse(robot, arm, goal, qStart)
%   q = smileInverse(robot, arm, goal, qStart, 'anyTurn', true)
%
%   robot   from smileRobot
%   arm     'left' or 'right'
%   goal    4x4, wanted pose of the tool in the world [units]
%   qStart  1x7 angles at which the search starts [rad]
%   q       1x7 within the limits [rad]; [] if no solution is found
%
%   Options, by name:
%     anyTurn            false   any rotation of the tool about its own axis z is accepted
%     positionTolerance  1e-6    [units]
%     angleTolerance     1e-6    [rad]
%     maxIterations      2000    limit for all attempts together
%     seed               1       seed of the start angles of further attempts
%
%   Equal inputs give equal results, also in C++ and Python.
  if nargin < 4, error('smileInverse: expected robot, arm, goal, qStart'); end
  q = smilemotion('smileInverse', robot, arm, goal, qStart, varargin{:});
end
