function points = armPoints(arm, q)
% Returns points along an arm from its tool to its first joint, Mx3 [units]: on the axis of each joint that
% turns, the point that is closest to the one before. They follow from the Jacobian: a joint with axis w
% moves the tool by v = w x r, r from the axis to the tool.
  pose = smileForward(arm.robot, arm.name, q);
  point = pose(1:3, 4)';
  points = point;
  columns = smileJacobian(arm.robot, arm.name, q)(:, end:-1:1)';
  v = columns(:, 1:3);
  axes = columns(:, 4:6);
  % v x w; Octave's own `cross` takes as long as all else here.
  on_axes = point - (v(:, [2, 3, 1]) .* axes(:, [3, 1, 2]) - v(:, [3, 1, 2]) .* axes(:, [2, 3, 1]));
  for k = find(any(axes, 2))'
    axis = axes(k, :);
    on_axis = on_axes(k, :);
    point = on_axis + axis * ((point - on_axis) * axis');
    points(end + 1, :) = point;
  end
end
