function [q, velocities] = smileSample(trajectory, seconds)
%SMILESAMPLE  Joint angles and velocities at times of a trajectory.
%
%   [q, velocities] = smileSample(trajectory, seconds)
%
%   trajectory  from smileMoveJoints or smileMoveLine
%   seconds     K times since its start; the joints rest before the start and after the end
%   q           Kx7 (2x7xK for both arms) [rad]
%   velocities  Kx7 (2x7xK for both arms) [rad/s]
  if nargin < 2, error('smileSample: expected trajectory, seconds'); end
  [q, velocities] = smilemotion('smileSample', trajectory, seconds);
end
