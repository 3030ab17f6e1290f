function yes = isWithinReach(robot, arm, place)
% Whether an arm gets its tool to a block's place, and 2 units above it.
  names = {'left', 'right'};
  yes = true;
  for height = [place.position(3) + 0.3, place.position(3) + 2]
    pose = toolPose([place.position(1:2), height], place.yaw + pi / 2);
    yes = yes && ~isempty(smileInverse(robot, names{arm}, pose, parkedAngles(arm), ...
                                       'maxIterations', 200));
  end
end
