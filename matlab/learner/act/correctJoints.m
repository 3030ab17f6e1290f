function [joints, sensor] = correctJoints(joints, sensor, tick_seconds)
% Replaces the measured joint angles in `sensor` by estimates: see jointEstimates().
  c = constants().joint_estimates;
  num_ticks = round(sensor.timeElapsed / tick_seconds);
  joints.has_moved = joints.has_moved || any(cellfun(@(told) any(told(:)), joints.told));
  if ~joints.has_moved
    for k = 1:numel(sensor.arms)
      joints.rest = [joints.rest; sensor.arms(k).joints(:) - joints.starts{k}];
    end
  end
  noise = sqrt(mean(joints.rest .^ 2));
  for k = 1:numel(sensor.arms)
    if noise < c.least_noise_rad
      joints.angles{k} = sensor.arms(k).joints(:);
      continue
    end
    joints = predict(joints, k, num_ticks, tick_seconds, c);
    joints = believe(joints, k, sensor.arms(k).joints(:) - joints.angles{k}, noise, c);
    sensor.arms(k).joints(:) = joints.angles{k};
  end
end

function joints = predict(joints, k, num_ticks, tick_seconds, c)
% Moves the estimate of an arm as its motors were told for some ticks.
  if isempty(joints.told) || num_ticks == 0, return; end
  told = joints.told{k};
  if size(told, 2) == 1, told = repmat(told, 1, num_ticks); end
  told = told(:, 1:num_ticks);
  % The servos run ahead of what they are told, in proportion to the velocity.
  ahead = c.ahead_s * (told(:, end) - joints.last{k});
  joints.angles{k} = joints.angles{k} + sum(told, 2) * tick_seconds + ahead;
  joints.last{k} = told(:, end);
  if any(told(:)), joints.variances(k) = joints.variances(k) + num_ticks * c.drift_rad ^ 2; end
end

function joints = believe(joints, k, surprise, noise, c)
% Corrects the estimate of an arm by what was measured beyond it.
  % Noise has no direction. Measurements that differ from the prediction in one direction again and again
  % tell of an obstacle: then the motors are not to be believed.
  last = [joints.surprises{k}, surprise];
  last = last(:, max(1, end - c.num_surprises + 1):end);
  joints.surprises{k} = last;
  error = noise / sqrt(c.num_surprises);
  if size(last, 2) == c.num_surprises && max(abs(mean(last, 2))) > c.doubt * error
    joints.variances(k) = noise ^ 2;
    joints.surprises{k} = [];
  end
  gain = joints.variances(k) / (joints.variances(k) + noise ^ 2);
  joints.angles{k} = joints.angles{k} + gain * surprise;
  joints.variances(k) = joints.variances(k) * (1 - gain);
end
