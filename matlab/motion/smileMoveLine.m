function [trajectory, fault] = smileMoveLine(robot, arm, qFrom, goal, varargin)
%SMILEMOVELINE  Plans a motion of the tool along a straight line.
%
%   [trajectory, fault] = smileMoveLine(robot, arm, qFrom, goal)
%   [trajectory, fault] = smileMoveLine(robot, arm, qFrom, goal, 'toolSpeed', 2, 'anyTurn', true)
%
%   robot      from smileRobot
%   arm        its name
%   qFrom      1xn, positions at the start [rad; m]
%   goal       4x4, goal pose of the tool in the world [units]
%   trajectory for smileSample; [] if the arm cannot follow the line
%   fault      [], or a struct if it cannot: fraction is the completed fraction of the line (0 to 1), reason the cause
%
%   Options, by name:
%     speed      1      fraction of the joints' maximum velocities, above 0, at most 1
%     toolSpeed  Inf    maximum speed of the tool [units/s]
%     anyTurn    false  the tool may rotate about its own axis z during the motion and at its end
%     anyRotation false the tool may rotate in any way
  if nargin < 4, error('smileMoveLine: expected robot, arm, qFrom, goal'); end
  [trajectory, fault] = smilemotion('smileMoveLine', robot, arm, qFrom, goal, varargin{:});
end
