function [action, velocity, status] = moveArm(action, sensor)
% One step of a motion: the velocities that bring the joints where they should be at its end.
  velocity = zeros(1, 7);
  status = 'busy';
  q = sensor.jointAngles(action.arm, :);
  if ~isfield(action, 'motion')
    action.motion = planMotion(q, action.to, action.arm);
    action.time = 0;
    if isempty(action.motion)
      status = 'a place is out of reach';
      return
    end
  end

  action.time = action.time + sensor.timeElapsed;
  velocity = (anglesAt(action.motion, action.time) - q) / sensor.timeElapsed;

  % It is over when the joints have arrived, whatever the clock says.
  late = action.time - action.motion.duration;
  if late > 0 && max(abs(action.motion.angles(end, :) - q)) < 0.001
    velocity = zeros(1, 7);
    status = 'done';
  elseif late > 1.5
    status = 'something is in the way of the arm';
  end
end
