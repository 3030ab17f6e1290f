if isfield(sensor, 'rgbVision')
  actions = planTask(robot, aside, sensor, aux);
end
motor.jointVelocities = zeros(2, 7);
motor.gripperVelocities = [0; 0];

% An action that has ended makes room for the next one.
if ~isempty(actions) && ~isempty(began)
  action = actions{1};
  if strcmp(action.kind, 'follow')
    left = max(abs(action.motion.positions(end, :) - sensor.jointAngles(action.arm, :)));
    late = sensor.simTime - began - action.motion.duration;
    has_ended = late > 1 || (late > 0 && left < settled);  % an arm that is blocked does not settle
  else
    % A gripper that holds something, or is open, stands still.
    opening = sensor.gripperOpening(action.arm);
    if abs(opening - last_opening) > 0.001, moved = sensor.simTime; end
    last_opening = opening;
    has_ended = sensor.simTime > moved + 0.2 || action.velocity * (action.opening - opening) <= 0;
  end
  if has_ended
    actions(1) = [];
    began = [];
  end
end

if isempty(actions)
  aux.exit = sensor.simTime > 1;
  if aux.exit, printf('%.1f s: done\n', sensor.simTime); end
  return
end
action = actions{1};
if isempty(began)
  began = sensor.simTime;
  moved = began;
  last_opening = sensor.gripperOpening(action.arm);
end
if strcmp(action.kind, 'follow')
  [q, velocities] = smileSample(action.motion, sensor.simTime - began);
  motor.jointVelocities(action.arm, :) = velocities + gain * (q - sensor.jointAngles(action.arm, :));
else
  motor.gripperVelocities(action.arm) = action.velocity;
end
