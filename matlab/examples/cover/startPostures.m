function postures = startPostures(robot, arm, aside)
% Returns angles from which to try to reach a pose, one in each row: the same each time.
  rand('twister', 1);
  low = robot.minJointAngles(arm, :);
  high = robot.maxJointAngles(arm, :);
  postures = [aside(arm, :); robot.poses.untucked(arm, :); low + rand(10, 7) .* (high - low)];
end
