function [action, motor, status] = carryOut(action, sensor)
% One step of an action. status is 'busy', 'done', or what went wrong. What must be remembered until
% the next step is kept in the action itself.
%   action.kind  'look', 'move' (with arm, to), 'close' or 'open' (with arm)
  motor = struct('jointVelocities', zeros(2, 7), 'gripperVelocities', [0; 0]);
  status = 'busy';
  switch action.kind
    case 'look'  % images come only now and then
      if isfield(sensor, 'rgbVision'), status = 'done'; end
    case 'move'
      [action, motor.jointVelocities(action.arm, :), status] = moveArm(action, sensor);
    case 'close'
      [action, motor.gripperVelocities(action.arm), status] = closeGripper(action, sensor);
    case 'open'
      motor.gripperVelocities(action.arm) = 1;
      if ~isfield(action, 'time'), action.time = 0; end
      action.time = action.time + sensor.timeElapsed;
      if sensor.gripperOpening(action.arm) > 1.95
        status = 'done';
      elseif action.time > 3
        status = 'something keeps the gripper from opening';
      end
  end
end
