function q = raisedPosture(arm)
% Returns joint angles with the tool above the place of the pose `ready`, or closer to the robot, as high
% as possible.
  c = constants().arms;
  tool = smileForward(arm.robot, arm.name, arm.ready);
  over = tool(1:2, 4)';
  for height = c.parked_heights(1):c.parked_heights(2):c.parked_heights(3)
    for fraction = c.parked_distances'
      place = arm.foot + fraction * (over - arm.foot);
      q = armInverse(arm, toolPose(arm, [place, height], 0, 0), arm.ready, 'anyTurn', true);
      if ~isempty(q) && isValidAt(arm, q), return; end
    end
  end
  q = arm.ready;
end
