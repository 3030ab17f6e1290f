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
