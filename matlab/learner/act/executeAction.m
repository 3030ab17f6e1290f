function [action, motor, status, image_seconds, sensor] = executeAction(action, sensor, aux)
% Executes one step of an action, of one tick, or of several where no feedback is needed. Values needed in
% the next step are kept in the action.
%   status  'busy', 'done', or a description of the failure
%   image_seconds  time to the next picture
%   sensor  with the mean of several pictures, if the observed ones have noise
%   action.kind  'observe'  waits for pictures of the arms at rest
%                'look'     waits for a picture of the camera of an arm's hand
%                'follow'   follows a path with an arm
%                'lift'     likewise, with a block; fails as soon as the arm does not keep up
%                'push'     likewise, with a block in front of the fingers
%                'press'    likewise, until something stops it, and back
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
      [action, motor.ticks, status, image_seconds, sensor] = waitForPictures(action, sensor, aux);
    case 'look'
      image_seconds = 0;  % with the next step
      if action.time <= c.settle_s || ~isfield(sensor, 'cameras')
        motor.ticks = max(ticksWithin(c.settle_s - action.time, aux) + 1, 1);
        return
      end
      image_seconds = c.no_image_s;
      status = 'done';
    case {'follow', 'lift', 'push'}
      [action, velocities, status] = followPath(action, sensor, aux);
      motor.ticks = size(velocities, 2);
      motor.arms(action.arm.index).velocities = velocities;
    case 'press'
      [action, motor.arms(action.arm.index).velocities, status] = pressAlong(action, sensor, aux);
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
