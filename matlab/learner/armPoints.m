function points = armPoints(arm, q)
% Returns points along an arm from its tool to its first joint, Mx3 [units]: on the axis of each joint that
% turns, the point that is closest to the one before. They follow from the Jacobian: a joint with axis w
% moves the tool by v = w x r, r from the axis to the tool.
  pose = smileForward(arm.robot, arm.name, q);
  tool = pose(1:3, 4)';
  points = tool;
  columns = fliplr(smileJacobian(arm.robot, arm.name, q))';
  axes = columns(:, 4:6);
  on_axes = tool - cross(columns(:, 1:3), axes, 2);
  for k = find(any(axes, 2))'
    points(end + 1, :) = on_axes(k, :) + axes(k, :) * ((points(end, :) - on_axes(k, :)) * axes(k, :)');
  end
end
