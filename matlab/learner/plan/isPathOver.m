function yes = isPathOver(arm, path, blocks)
% Returns true if an arm and its hand pass over blocks, or beside them, all along a path.
  yes = false;
  for q = samplesOf(path)'
    tool = smileForward(arm.robot, arm.name, q');
    hand = tool(1:3, 4)' + arm.reach * [1; 0; -1] * tool(1:3, 3)';
    is_clear = isArmClear(arm, q', blocks) && all(isPointClear(hand, blocks, constants().motion_planning.clearance));
    if ~is_clear, return; end
  end
  yes = true;
end
