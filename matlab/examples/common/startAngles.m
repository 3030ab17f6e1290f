function starts = startAngles(robot, arm, aside)
% Returns angles at which a search for those of a pose may start, one in each row: the same each time.
  rand('twister', 1);
  low = robot.minJointAngles(arm, :);
  high = robot.maxJointAngles(arm, :);
  starts = aside(arm, :);
  for name = {'untucked', 'ready'}
    if isfield(robot.poses, name{1}), starts(end + 1, :) = robot.poses.(name{1})(arm, :); end
  end
  starts = [starts; low + rand(10, numel(low)) .* (high - low)];
end
