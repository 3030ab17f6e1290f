% Wave with shoulder S0 and wrist W0, the right arm as the mirror image of the left one, while the
% grippers slowly open and close.
swing = cos(2 * pi * sensor.simTime / period);
motor.jointVelocities = zeros(2, 7);
motor.jointVelocities(:, 1) = [1; -1] * speed * swing;
motor.jointVelocities(:, 5) = [1; -1] * speed * swing;
motor.gripperVelocities = 0.5 * [swing; swing];

if sensor.simTime >= next_report
  fprintf('%5.1f s: left gripper at %6.2f %6.2f %6.2f\n', sensor.simTime, sensor.endEffPos(1, :));
  next_report = next_report + period;
end
