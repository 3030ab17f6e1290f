function [q, reason] = smileInverse(robot, arm, goal, qStart, varargin)
%SMILEINVERSE  Joint angles that put an arm's tool at a pose.
%
%   q = smileInverse(robot, arm, goal, qStart)
%   q = smileInverse(robot, arm, goal, qStart, 'anyTurn', true)
%   [q, reason] = smileInverse(...)
%
%   robot   from smileRobot
%   arm     its name
%   goal    4x4, wanted pose of the tool in the world [units]; 4x4xN for several, one after the other
%   qStart  1xn positions at which the search starts [rad; m]; for each further goal it starts at the solution for the one before
%   q       1xn within the limits [rad; m]; Nxn for several goals; [] if no solution is found for one of them
%   reason  '', or why no solution is found: whether another rotation of the tool would be reached
%
%   Options, by name:
%     anyTurn            false   any rotation of the tool about its own axis z is accepted
%     anyRotation        false   any rotation of the tool is accepted, only its position matters: arms
%                                of fewer than six joints cannot take every rotation
%     positionTolerance  1e-6    [units]
%     angleTolerance     1e-6    [rad]
%     maxIterations      2000    limit for all attempts together
%     seed               1       seed of the start angles of further attempts
%
%   Equal inputs give equal results, also in C++ and Python.
  if nargin < 4, error('smileInverse: expected robot, arm, goal, qStart'); end
  if nargout < 2
    q = smilemotion('smileInverse', robot, arm, goal, qStart, varargin{:});
  else
    [q, reason] = smilemotion('smileInverse', robot, arm, goal, qStart, varargin{:});
  end
end
