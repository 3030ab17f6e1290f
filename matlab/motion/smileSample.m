function [q, velocities] = smileSample(trajectory, seconds)
%SMILESAMPLE  Where the joints are at a moment of a trajectory, and how fast.
%
%   [q, velocities] = smileSample(trajectory, seconds)
%
%   trajectory  from smileMoveJoints or smileMoveLine
%   seconds     since its start; before it and after its end the joints rest
%   q           1x7 (2x7 for both arms) [rad]
%   velocities  1x7 (2x7 for both arms) [rad/s]
  if nargin < 2, error('smileSample: expected trajectory, seconds'); end
  [q, velocities] = smilemotion('smileSample', trajectory, seconds);
end
