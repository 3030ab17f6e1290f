function [action, velocity, status] = closeGripper(action, sensor)
% One step of taking hold: closes until the fingers stop. Between them must then be a block.
  velocity = -1;  % units/s
  status = 'busy';
  opening = sensor.gripperOpening(action.arm);
  if ~isfield(action, 'opening')
    action.opening = opening;
    action.rest = 0;
  elseif abs(opening - action.opening) < 0.001
    action.rest = action.rest + sensor.timeElapsed;
  else
    action.rest = 0;
  end
  action.opening = opening;
  if action.rest < 0.2, return; end
  velocity = 0;
  if opening > 0.9 && opening < 1.2
    status = 'done';
  else
    status = sprintf('the gripper closed to %.2f units: no block', opening);
  end
end
