function points = armPoints(arm, q)
% Returns points along an arm from its tool to its first joint, Mx3 [units]: on the axis of each joint that
% turns, the point that is closest to the one before. They follow from the Jacobian: a joint with axis w
% moves the tool by v = w x r, r from the axis to the tool.
  pose = smileForward(arm.robot, arm.name, q);
  tool = pose(1:3, 4)';
  points = tool;
  for column = fliplr(smileJacobian(arm.robot, arm.name, q))
    v = column(1:3)';
    w = column(4:6)';
    if any(w)
      on_axis = tool - cross(v, w);
      points(end + 1, :) = on_axis + w * ((points(end, :) - on_axis) * w');
    end
  end
end
