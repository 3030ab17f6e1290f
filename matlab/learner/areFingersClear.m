function yes = areFingersClear(arm, path, blocks)
% Returns true if the fingers and the hand of an arm pass over blocks, or beside them, on a path.
  points = zeros(0, 3);
  for q = samplesOf(path)'
    tool = smileForward(arm.robot, arm.name, q');
    points = [points; tool(1:3, 4)' + arm.reach * [1; 0; -1] * tool(1:3, 3)'];
  end
  yes = all(isPointClear(points, blocks, constants().motion_planning.clearance));
end
