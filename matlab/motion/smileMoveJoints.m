function trajectory = smileMoveJoints(robot, arm, waypoints, varargin)
%SMILEMOVEJOINTS  Plans a motion of the joints through waypoints, from rest to rest, within all limits.
%
%   trajectory = smileMoveJoints(robot, arm, waypoints)
%   trajectory = smileMoveJoints(robot, arm, waypoints, 'speed', 0.5)
%
%   robot      from smileRobot
%   arm        its name, or 'both' for all arms
%   waypoints  Kxn [rad; m]; NxnxK for 'both', if all N arms have n joints, otherwise one row each
%   speed      fraction of the joints' maximum velocities, above 0, at most 1
%   trajectory for smileSample: a struct with times 1xK [s], positions and velocities Kxn (for
%              'both' of all joints, arm after arm) and duration [s]
  if nargin < 3, error('smileMoveJoints: expected robot, arm, waypoints'); end
  trajectory = smilemotion('smileMoveJoints', robot, arm, waypoints, varargin{:});
end
