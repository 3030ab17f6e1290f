function [action, motor, status] = executeAction(action, sensor)
% Executes one time step of an action. Values needed in the next step are kept in the action.
%   status  'busy', 'done', or a description of the failure
%   action.kind  'observe'  waits for a picture of the arms at rest
%                'follow'   follows a path with an arm
%                'open'     brings the fingers of an arm to an opening `to` [units]
%                'grasp'    closes the fingers on a block of a `width` [units]
  motor = struct('jointVelocities', zeros(2, 7), 'gripperVelocities', [0; 0]);
  status = 'busy';
  c = constants().execution;
  if ~isfield(action, 'time'), action.time = 0; end
  action.time = action.time + sensor.timeElapsed;
  switch action.kind
    case 'observe'  % pictures are not taken every step; the first may show the moving arm
      if isfield(sensor, 'rgbVision') && action.time > c.settle_s, status = 'done'; end
    case 'follow'
      [action, motor.jointVelocities(action.arm, :), status] = followPath(action, sensor);
    case 'open'
      remaining = action.to - sensor.gripperOpening(action.arm);
      speed = remaining / sensor.timeElapsed;
      motor.gripperVelocities(action.arm) = max(-c.opening_speed, min(c.opening_speed, speed));
      if abs(remaining) < c.opening_tolerance
        motor.gripperVelocities(action.arm) = 0;
        status = 'done';
      elseif action.time > c.opening_timeout_s
        status = 'an obstacle keeps the fingers from opening';
      end
    case 'grasp'
      [action, motor.gripperVelocities(action.arm), status] = closeOn(action, sensor);
  end
end

function [action, velocity, status] = followPath(action, sensor)
% Follows a path until the measured joints have arrived, not until a fixed time.
  c = constants().execution;
  q = sensor.jointAngles(action.arm, :);
  status = 'busy';
  velocity = (smileSample(action.path, action.time) - q) / sensor.timeElapsed;
  delay = action.time - action.path.duration;
  if delay <= 0, return; end
  if ~isfield(action, 'errors'), action.errors = zeros(0, 7); end
  first = max(1, size(action.errors, 1) - c.num_averaged + 2);
  action.errors = [action.errors(first:end, :); action.path.positions(end, :) - q];
  if haveArrived(action.errors, c)
    velocity = zeros(1, 7);
    status = 'done';
  elseif delay > c.max_delay_s
    status = 'an obstacle is in the way of the arm';
  end
end

function yes = haveArrived(errors, c)
% Returns true if the last joint error, or the mean of the last ones, Nx7 [rad], is small. Averaging
% suppresses the noise of the measurements.
  yes = max(abs(errors(end, :))) < c.joint_tolerance_rad || ...
        (size(errors, 1) == c.num_averaged && max(abs(mean(errors, 1))) < c.joint_tolerance_rad);
end

function [action, velocity, status] = closeOn(action, sensor)
% Closes the fingers until they stop. They must then be at the width of the block.
  c = constants().execution;
  velocity = -c.closing_speed;
  status = 'busy';
  opening = sensor.gripperOpening(action.arm);
  if ~isfield(action, 'opening') || abs(opening - action.opening) > c.still_opening
    action.opening = opening;
    action.still_time = 0;
  end
  action.still_time = action.still_time + sensor.timeElapsed;
  if action.still_time < c.still_s, return; end
  velocity = 0;
  if abs(opening - action.width) < c.width_tolerance
    status = 'done';
  else
    status = sprintf('the fingers closed to %.2f units without a block', opening);
  end
end
