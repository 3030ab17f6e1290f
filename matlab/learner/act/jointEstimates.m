function joints = jointEstimates(starts)
% Returns estimates of the joint angles of all arms, for correctJoints(): a Kalman filter for each arm, with
% one variance for all its joints. They move as the motors are told, but for a drift, and are measured with
% the noise that shows while nothing moves yet. Sensors without noise are believed.
%   starts  joint angles of each arm in the first step {nx1} [rad]
  joints.starts = starts;
  joints.angles = starts;
  joints.variances = zeros(size(starts));  % of the estimates [rad2]
  joints.surprises = cell(size(starts));   % measured less predicted, the last few, nxN
  joints.has_moved = false;
  joints.rest = [];                        % measured less known, while nothing has moved
  joints.told = {};                        % velocities of each arm, nxN for N ticks, or nx1 [rad/s]
  joints.last = cellfun(@(q) zeros(size(q)), starts, 'UniformOutput', false);  % the last told [rad/s]
end
