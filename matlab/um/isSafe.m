function yes = isSafe(robot, path, arm)
% Whether an arm can go along a path while the other one is parked. It keeps off its joints' limits: there
% it might stop short, and with S0 turned far to the other side the upper arm would touch the chest.
  margin = [0.2, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02];  % rad
  lower = robot.minJointAngles(arm, :) + margin;
  upper = robot.maxJointAngles(arm, :) - margin;
  yes = all(all(path.positions > lower & path.positions < upper)) && ...
        isempty(smileFirstInvalid(robot, path, 'qBoth', [parkedAngles(1); parkedAngles(2)]));
end
