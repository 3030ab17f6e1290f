function yes = areFingersClear(arm, path, blocks)
% Returns true if the fingers and the hand of an arm are over blocks, or beside them, at the points of a path, which may be its
% ends: with its margins, in between, the check would forbid most turns of planks.
  points = zeros(0, 3);
  step = max(floor(rows(path.positions) / constants().motion_planning.samples_per_path), 1);
  for q = path.positions(1:step:end, :)'
    tool = smileForward(arm.robot, arm.name, q');
    points = [points; tool(1:3, 4)' + arm.reach * [1; 0; -1] * tool(1:3, 3)'];
  end
  yes = all(isPointClear(points, blocks, constants().motion_planning.clearance));
end
