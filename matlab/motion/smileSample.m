function [q, velocities] = smileSample(trajectory, seconds)
%SMILESAMPLE  Joint angles and velocities at a time of a trajectory.
%
%   [q, velocities] = smileSample(trajectory, seconds)
%
%   trajectory  from smileMoveJoints or smileMoveLine
%   seconds     time since its start; the joints rest before the start and after the end
%   q           1x7 (2x7 for both arms) [rad]
%   velocities  1x7 (2x7 for both arms) [rad/s]
  if nargin < 2, error('smileSample: expected trajectory, seconds'); end
  [q, velocities] = smilemotion('smileSample', trajectory, seconds);
end
