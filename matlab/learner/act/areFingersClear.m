function yes = areFingersClear(arm, path, blocks)
% Returns true if the fingers and the hand of an arm are over blocks, or beside them, at the points of a path, which may be its
% ends: with its margins, in between, the check would forbid most turns of planks.
  step = max(floor(rows(path.positions) / constants().motion_planning.samples_per_path), 1);
  tools = smileForward(arm.robot, arm.name, path.positions(1:step:end, :));
  points = kron(columnsOf(tools, 4), ones(3, 1)) + kron(columnsOf(tools, 3), arm.reach * [1; 0; -1]);
  yes = all(isPointClear(points, blocks, constants().motion_planning.clearance));
end
