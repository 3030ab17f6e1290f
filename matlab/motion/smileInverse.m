function q = smileInverse(robot, arm, goal, qStart, varargin)
%SMILEINVERSE  Angles that bring an arm's tool to a pose.
%
%   q = smileInverse(robot, arm, goal, qStart)
%   q = smileInverse(robot, arm, goal, qStart, 'anyTurn', true)
%
%   robot   from smileRobot
%   arm     'left' or 'right'
%   goal    4x4, wanted pose of the tool in the world [units]
%   qStart  1x7 angles near which to look first [rad]
%   q       1x7 within the limits [rad]; [] when none were found
%
%   Options, by name:
%     anyTurn            false   the tool may be turned about its own axis z as the arm likes
%     positionTolerance  1e-6    [units]
%     angleTolerance     1e-6    [rad]
%     maxIterations      2000    of all attempts together
%     seed               1       of the places where further attempts start
%
%   The same question has the same answer, in C++ and Python, too.
  if nargin < 4, error('smileInverse: expected robot, arm, goal, qStart'); end
  q = smilemotion('smileInverse', robot, arm, goal, qStart, varargin{:});
end
