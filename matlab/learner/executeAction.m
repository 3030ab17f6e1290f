function [action, motor, status, image_seconds, sensor] = executeAction(action, sensor, aux)
% Executes one step of an action, of one tick, or of several where no feedback is needed. Values needed in
% the next step are kept in the action.
%   status  'busy', 'done', or a description of the failure
%   image_seconds  time to the next picture
%   sensor  with the mean of several pictures, if the observed ones have noise
%   action.kind  'observe'  waits for pictures of the arms at rest
%                'follow'   follows a path with an arm
%                'open'     brings the fingers of an arm to an opening `to` [units]
%                'grasp'    closes the fingers on a block of a `width` [units]
  still = cellfun(@(joints) zeros(numel(joints), 1), {aux.arms.joints}, 'UniformOutput', false);
  motor = struct('arms', struct('velocities', still, 'gripperVelocity', 0), 'ticks', 1);
  status = 'busy';
  c = constants().execution;
  image_seconds = c.no_image_s;
  if ~isfield(action, 'time'), action.time = 0; end
  action.time = action.time + sensor.timeElapsed;
  switch action.kind
    case 'observe'
      [action, motor.ticks, status, image_seconds, sensor] = lookOn(action, sensor, aux);
    case 'follow'
      [action, velocities, status] = followPath(action, sensor, aux);
      motor.ticks = size(velocities, 2);
      motor.arms(action.arm.index).velocities = velocities;
    case 'open'
      remaining = action.to - sensor.arms(action.arm.index).gripper;
      if abs(remaining) < c.opening_tolerance
        status = 'done';
        return
      end
      speed = max(-c.opening_speed, min(c.opening_speed, remaining / aux.tickSeconds));
      motor.arms(action.arm.index).gripperVelocity = speed;
      motor.ticks = max(ticksWithin(remaining / speed, aux), 1);
      if action.time > c.opening_timeout_s
        status = 'an obstacle keeps the fingers from opening';
      end
    case 'grasp'
      [action, motor.arms(action.arm.index).gripperVelocity, motor.ticks, status] = ...
          closeOn(action, sensor, aux);
  end
end

function ticks = ticksWithin(seconds, aux)
% Returns the number of whole ticks in some time, as far as a step can last that long.
  ticks = min(max(floor(seconds / aux.tickSeconds), 0), aux.maxTicks);
end

function [action, ticks, status, image_seconds, sensor] = lookOn(action, sensor, aux)
% Waits until the arms rest, then for a picture; if it has noise, for so many that their mean has little,
% which takes the place of the last one.
  c = constants().execution;
  ticks = 1;
  status = 'busy';
  image_seconds = 0;  % with the next step
  if action.time <= c.settle_s || ~isfield(sensor, 'rgbVision')
    ticks = max(ticksWithin(c.settle_s - action.time, aux) + 1, 1);
    return
  end
  if ~isfield(action, 'pictures')
    action.pictures = struct('sum', 0, 'count', 0, 'wanted', numPictures(sensor.rgbVision));
  end
  action.pictures.sum = action.pictures.sum + sensor.rgbVision;
  action.pictures.count = action.pictures.count + 1;
  if action.pictures.count < action.pictures.wanted, return; end
  if action.pictures.count > 1, sensor.rgbVision = action.pictures.sum / action.pictures.count; end
  image_seconds = c.no_image_s;
  status = 'done';
end

function [action, velocities, status] = followPath(action, sensor, aux)
% Follows a path until the measured joints have arrived, not until a fixed time. The velocities along the
% path, nxN, are chunks of N ticks. After its end, each tick has feedback.
  c = constants().execution;
  q = sensor.arms(action.arm.index).joints(:)';
  status = 'busy';
  delay = action.time - action.path.duration;
  num_ticks = min(ticksWithin(-delay, aux) + 1, c.chunk_ticks);
  % action.time is the end of the first of these ticks.
  wanted = smileSample(action.path, action.time + aux.tickSeconds * (0:num_ticks - 1));
  velocities = diff([q; wanted]).' / aux.tickSeconds;
  if delay <= 0, return; end
  if max(abs(action.path.positions(end, :) - q)) < c.joint_tolerance_rad
    velocities = zeros(numel(q), 1);
    status = 'done';
  elseif delay > c.max_delay_s
    status = 'an obstacle is in the way of the arm';
  end
end

function [action, velocity, ticks, status] = closeOn(action, sensor, aux)
% Closes the fingers until they stop. They must then be at the width of the block.
  c = constants().execution;
  velocity = -c.closing_speed;
  status = 'busy';
  opening = sensor.arms(action.arm.index).gripper;
  if ~isfield(action, 'opening') || abs(opening - action.opening) > c.still_opening
    action.opening = opening;
    action.still_time = 0;
  else
    action.still_time = action.still_time + sensor.timeElapsed;
  end
  free = opening - action.width - c.width_tolerance;
  ticks = max(ticksWithin(free / c.closing_speed, aux), 1);
  if action.still_time < c.still_s, return; end
  velocity = 0;
  ticks = 1;
  if abs(opening - action.width) < c.width_tolerance
    status = 'done';
  else
    status = sprintf('the fingers closed to %.2f units without a block', opening);
  end
end
