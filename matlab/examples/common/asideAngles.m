function aside = asideAngles(robot)
% Returns the angles at which arms wait, a row for each: those of Baxter, or a pose of another robot.
  if isequal(size(robot.minJointAngles), [2, 7])
    aside = [1.3 -1 -1.19 1.94 0.67 1.03 -0.5; -1.3 -1 1.19 1.94 -0.67 1.03 0.5];
  elseif isfield(robot.poses, 'folded')
    aside = robot.poses.folded;
  elseif isfield(robot.poses, 'ready')
    aside = robot.poses.ready;
  else
    error('the robot has no pose folded or ready');
  end
end
