function [action, motor, status] = carryOut(action, sensor)
% One step of an action. status is 'busy', 'done', or what went wrong. What must be remembered until
% the next step is kept in the action itself.
%   action.kind  'look'
%                'follow' a path, with an arm
%                'grip': the arm's fingers are brought `to` an opening [units]
%                'take': they close on a block of a `width`
  motor = struct('jointVelocities', zeros(2, 7), 'gripperVelocities', [0; 0]);
  status = 'busy';
  if ~isfield(action, 'time'), action.time = 0; end
  action.time = action.time + sensor.timeElapsed;
  switch action.kind
    case 'look'  % images come only now and then; the first may be of a moment when the arm still moved
      if isfield(sensor, 'rgbVision') && action.time > 0.1, status = 'done'; end
    case 'follow'
      [action, motor.jointVelocities(action.arm, :), status] = followPath(action, sensor);
    case 'grip'
      gap = action.to - sensor.gripperOpening(action.arm);
      motor.gripperVelocities(action.arm) = max(-3, min(3, gap / sensor.timeElapsed));
      if abs(gap) < 0.02
        motor.gripperVelocities(action.arm) = 0;
        status = 'done';
      elseif action.time > 3
        status = 'something keeps the fingers from opening';
      end
    case 'take'
      [action, motor.gripperVelocities(action.arm), status] = closeOn(action, sensor);
  end
end

function [action, velocity, status] = followPath(action, sensor)
  q = sensor.jointAngles(action.arm, :);
  status = 'busy';
  velocity = (smileSample(action.path, action.time) - q) / sensor.timeElapsed;
  % It is over when the joints have arrived, whatever the clock says.
  late = action.time - action.path.duration;
  if late <= 0, return; end
  if ~isfield(action, 'errors'), action.errors = zeros(0, 7); end
  action.errors = [action.errors(max(1, end - 10):end, :); action.path.positions(end, :) - q];
  if haveArrived(action.errors)
    velocity = zeros(1, 7);
    status = 'done';
  elseif late > 1.5
    status = 'something is in the way of the arm';
  end
end

function yes = haveArrived(errors)
% By the last measurement, or by the mean of the last 12: each has noise of its own.
  arrived = 0.001;  % largest joint error at the end of a path [rad]
  yes = max(abs(errors(end, :))) < arrived || ...
        (size(errors, 1) == 12 && max(abs(mean(errors, 1))) < arrived);
end

function [action, velocity, status] = closeOn(action, sensor)
% Closes until the fingers stop. Between them must then be the block.
  velocity = -2;  % units/s
  status = 'busy';
  opening = sensor.gripperOpening(action.arm);
  if ~isfield(action, 'opening') || abs(opening - action.opening) > 0.001
    action.opening = opening;
    action.rest = 0;
  end
  action.rest = action.rest + sensor.timeElapsed;
  if action.rest < 0.1, return; end
  velocity = 0;
  if abs(opening - action.width) < 0.15
    status = 'done';
  else
    status = sprintf('the fingers closed to %.2f units, on no block', opening);
  end
end
