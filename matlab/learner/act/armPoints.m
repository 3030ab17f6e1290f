function points = armPoints(arm, q)
% Returns points along an arm from its tool to its first joint, Mx3 for each row of q, Mx3xN [units]: on the axis of each joint that
% turns, the point that is closest to the one before. They follow from the Jacobian: a joint with axis w
% moves the tool by v = w x r, r from the axis to the tool.
%   q  joint angles, Nxn [rad]
  point = columnsOf(smileForward(arm.robot, arm.name, q), 4);
  jacobians = permute(smileJacobian(arm.robot, arm.name, q), [3, 1, 2]);
  v = jacobians(:, 1:3, end:-1:1);
  axes = jacobians(:, 4:6, end:-1:1);
  % v x w; Octave's own `cross` takes as long as all else here.
  on_axes = point - (v(:, [2, 3, 1], :) .* axes(:, [3, 1, 2], :) - v(:, [3, 1, 2], :) .* axes(:, [2, 3, 1], :));
  points = permute(point, [3, 2, 1]);
  for k = find(any(axes(1, :, :), 2))(:)'
    axis = axes(:, :, k);
    on_axis = on_axes(:, :, k);
    point = on_axis + axis .* sum((point - on_axis) .* axis, 2);
    points(end + 1, :, :) = point';
  end
end
