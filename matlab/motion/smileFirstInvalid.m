function moment = smileFirstInvalid(robot, trajectory, varargin)
%SMILEFIRSTINVALID  First moment at which a motion becomes invalid.
%
%   moment = smileFirstInvalid(robot, trajectory)
%   moment = smileFirstInvalid(robot, trajectory, 'qBoth', sensor.jointAngles, 'table', [20 12])
%
%   robot       from smileRobot
%   trajectory  from smileMoveJoints or smileMoveLine
%   moment      [] if the trajectory is valid; else a struct: seconds since the start, and reason: a
%               joint exceeds a limit, or the robot would touch itself or the table.
%
%   Options, by name:
%     qBoth  2x7, angles of the arms that do not move [rad]; default: the robot's start angles
%     table  [width depth] of a table centered at the origin, with its top at z = 0 [units]
%     held   2x3, lower and upper corner of a box around what the arm that moves holds, in the frame of its
%            tool [units]; it counts as part of the hand
  if nargin < 2, error('smileFirstInvalid: expected robot, trajectory'); end
  moment = smilemotion('smileFirstInvalid', robot, trajectory, varargin{:});
end
