function shoulders = findShoulders(sensor)
% Where the mounts of both arms are in the scene [units], 2x3: the simulator says where the tools
% are, kinematics says how far that is from the mounts.
  shoulders = zeros(2, 3);
  for arm = 1:2
    shoulders(arm, :) = sensor.endEffPos(arm, :) - forwardKinematics(sensor.jointAngles(arm, :), arm);
  end
end
