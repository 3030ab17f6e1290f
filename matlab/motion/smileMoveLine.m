function [trajectory, fault] = smileMoveLine(robot, arm, qFrom, goal, varargin)
%SMILEMOVELINE  A motion of the tool along a straight line.
%
%   [trajectory, fault] = smileMoveLine(robot, arm, qFrom, goal)
%   [trajectory, fault] = smileMoveLine(robot, arm, qFrom, goal, 'toolSpeed', 2, 'anyTurn', true)
%
%   robot      from smileRobot
%   arm        'left' or 'right'
%   qFrom      1x7, where the arm is [rad]
%   goal       4x4, where the tool shall be in the world [units]
%   trajectory for smileSample; [] when the arm cannot go along the line
%   fault      then a struct: share tells how far it comes (0 to 1), reason why not further; else []
%
%   Options, by name:
%     speed      1      share of the joints' greatest velocities, above 0, at most 1
%     toolSpeed  Inf    at most [units/s]
%     anyTurn    false  the tool may turn about its own axis z on the way and at the end
  if nargin < 4, error('smileMoveLine: expected robot, arm, qFrom, goal'); end
  [trajectory, fault] = smilemotion('smileMoveLine', robot, arm, qFrom, goal, varargin{:});
end
