function moment = smileFirstInvalid(robot, trajectory, varargin)
%SMILEFIRSTINVALID  When a motion stops being one that the robot can make.
%
%   moment = smileFirstInvalid(robot, trajectory)
%   moment = smileFirstInvalid(robot, trajectory, 'qBoth', sensor.jointAngles, 'table', [20 12])
%
%   robot       from smileRobot
%   trajectory  from smileMoveJoints or smileMoveLine
%   moment      [] when all of it is valid; else a struct: seconds since the start, and reason. A
%               joint breaks a limit, or the robot would touch itself or the table.
%
%   Options, by name:
%     qBoth  2x7, where the arms stand that do not move [rad]; else where the robot starts
%     table  [width depth] of a table whose top is z = 0 around the origin [units]
  if nargin < 2, error('smileFirstInvalid: expected robot, trajectory'); end
  moment = smilemotion('smileFirstInvalid', robot, trajectory, varargin{:});
end
