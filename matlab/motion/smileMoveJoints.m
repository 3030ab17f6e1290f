function trajectory = smileMoveJoints(robot, arm, waypoints, varargin)
%SMILEMOVEJOINTS  Plans a motion of the joints through waypoints, from rest to rest, within all limits.
%
%   trajectory = smileMoveJoints(robot, arm, waypoints)
%   trajectory = smileMoveJoints(robot, arm, waypoints, 'speed', 0.5)
%
%   robot      from smileRobot
%   arm        'left', 'right' or 'both'
%   waypoints  Kx7 angles [rad]; 2x7xK for 'both'
%   speed      fraction of the joints' maximum velocities, above 0, at most 1
%   trajectory for smileSample: a struct with times 1xK [s], positions and velocities Kx7 (Kx14 for
%              'both', left first) and duration [s]
  if nargin < 3, error('smileMoveJoints: expected robot, arm, waypoints'); end
  trajectory = smilemotion('smileMoveJoints', robot, arm, waypoints, varargin{:});
end
