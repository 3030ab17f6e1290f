function [action, motor, status] = carryOut(action, sensor)
% One step of an action. status is 'busy', 'done', or what went wrong. What must be remembered until
% the next step is kept in the action itself.
%   action.kind  'look'
%                'follow' a path, with an arm
%                'grip': the arm's fingers are brought `to` an opening [units]
%                'take': they close on a block of a `width`
  motor = struct('jointVelocities', zeros(2, 7), 'gripperVelocities', [0; 0]);
  status = 'busy';
  c = constants().act;
  if ~isfield(action, 'time'), action.time = 0; end
  action.time = action.time + sensor.timeElapsed;
  switch action.kind
    case 'look'  % images come only now and then; the first may be of a moment when the arm still moved
      if isfield(sensor, 'rgbVision') && action.time > c.settle_s, status = 'done'; end
    case 'follow'
      [action, motor.jointVelocities(action.arm, :), status] = followPath(action, sensor);
    case 'grip'
      gap = action.to - sensor.gripperOpening(action.arm);
      speed = gap / sensor.timeElapsed;
      motor.gripperVelocities(action.arm) = max(-c.opening_speed, min(c.opening_speed, speed));
      if abs(gap) < c.opening_error
        motor.gripperVelocities(action.arm) = 0;
        status = 'done';
      elseif action.time > c.opening_s
        status = 'something keeps the fingers from opening';
      end
    case 'take'
      [action, motor.gripperVelocities(action.arm), status] = closeOn(action, sensor);
  end
end

function [action, velocity, status] = followPath(action, sensor)
  c = constants().act;
  q = sensor.jointAngles(action.arm, :);
  status = 'busy';
  velocity = (smileSample(action.path, action.time) - q) / sensor.timeElapsed;
  % It is over when the joints have arrived, whatever the clock says.
  late = action.time - action.path.duration;
  if late <= 0, return; end
  if ~isfield(action, 'errors'), action.errors = zeros(0, 7); end
  first = max(1, size(action.errors, 1) - c.num_averaged + 2);
  action.errors = [action.errors(first:end, :); action.path.positions(end, :) - q];
  if haveArrived(action.errors, c)
    velocity = zeros(1, 7);
    status = 'done';
  elseif late > c.late_s
    status = 'something is in the way of the arm';
  end
end

function yes = haveArrived(errors, c)
% By the last measurement, or by the mean of the last ones: each has noise of its own.
  yes = max(abs(errors(end, :))) < c.arrived_rad || ...
        (size(errors, 1) == c.num_averaged && max(abs(mean(errors, 1))) < c.arrived_rad);
end

function [action, velocity, status] = closeOn(action, sensor)
% Closes until the fingers stop. Between them must then be the block.
  c = constants().act;
  velocity = -c.closing_speed;
  status = 'busy';
  opening = sensor.gripperOpening(action.arm);
  if ~isfield(action, 'opening') || abs(opening - action.opening) > c.still_opening
    action.opening = opening;
    action.rest = 0;
  end
  action.rest = action.rest + sensor.timeElapsed;
  if action.rest < c.still_s, return; end
  velocity = 0;
  if abs(opening - action.width) < c.width_error
    status = 'done';
  else
    status = sprintf('the fingers closed to %.2f units, on no block', opening);
  end
end
