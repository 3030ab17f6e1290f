function starts = startAngles(robot, arm, aside)
% Returns angles at which a search for those of a pose may start, one in each row: the same each time.
  rand('twister', 1);
  low = robot.minJointAngles(arm, :);
  high = robot.maxJointAngles(arm, :);
  starts = [aside(arm, :); robot.poses.untucked(arm, :); low + rand(10, 7) .* (high - low)];
end
