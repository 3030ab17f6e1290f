function [work, motor, aux] = stepWork(work, sensor, motor, aux)
% Carries out a step of the first action; the next one begins when it has ended. The brain ends after the last one.
  for k = 1:numel(sensor.arms)
    motor.arms(k).velocities = zeros(1, numel(sensor.arms(k).joints));
    motor.arms(k).gripperVelocity = 0;
  end
  if isempty(work.actions)
    printf('%.1f s: done\n', sensor.simTime);
    aux.exit = true;
    return
  end
  action = work.actions{1};
  if isempty(work.began)
    work.began = sensor.simTime;
    work.moved = sensor.simTime;
    if strcmp(action.kind, 'grip'), work.opening = sensor.arms(action.arm).gripper; end
  end
  switch action.kind
    case 'look'
      aux.imageSeconds = 0;
      if isfield(sensor, 'rgbVision') && sensor.simTime > work.began
        aux.imageSeconds = 3600;
        work = nextAction(work, action.next(sensor, aux));
      end
    case 'follow'
      seconds = sensor.simTime - work.began;
      [q, velocities] = smileSample(action.motion, seconds);
      now = sensor.arms(action.arm).joints;
      motor.arms(action.arm).velocities = velocities + 4 * (q - now);
      left = max(abs(action.motion.positions(end, :) - now));
      late = seconds - action.motion.duration;
      if late > 1 || (late > 0 && left < 0.002)  % an arm that is blocked does not settle
        motor.arms(action.arm).velocities(:) = 0;
        work = nextAction(work, {});
      end
    case 'grip'
      motor.arms(action.arm).gripperVelocity = action.velocity;
      opening = sensor.arms(action.arm).gripper;
      if abs(opening - work.opening) > 0.001, work.moved = sensor.simTime; end
      work.opening = opening;
      if sensor.simTime > work.moved + 0.2 || action.velocity * (action.opening - opening) <= 0
        motor.arms(action.arm).gripperVelocity = 0;
        work = nextAction(work, {});
      end
  end
end

function work = nextAction(work, actions)
  work.actions = [actions, work.actions(2:end)];
  work.began = [];
end
