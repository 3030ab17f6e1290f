function yes = isWithinReach(robot, arm, place)
% Whether an arm gets its tool to a block's place, and 2 units above it.
  names = {'left', 'right'};
  for across = place.yaw + [pi / 2, -pi / 2]
    q = parkedAngles(arm);
    for height = [place.position(3) + 2, place.position(3) + 0.3]
      pose = toolPose([place.position(1:2), height], across);
      q = smileInverse(robot, names{arm}, pose, q, 'maxIterations', 200);
      yes = ~isempty(q) && keepsOffChest(robot, arm, q);
      if ~yes, break; end
    end
    if yes, return; end
  end
end
