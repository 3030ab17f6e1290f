function yes = keepsOffLimits(robot, arm, q)
% Whether angles of an arm, Nx7, keep off its joints' limits: there they might stop short, and with S0
% turned far to the other side the upper arm would touch the chest.
  margin = [0.2, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02];  % rad
  lower = robot.minJointAngles(arm, :) + margin;
  upper = robot.maxJointAngles(arm, :) - margin;
  yes = all(all(q > lower & q < upper));
end
