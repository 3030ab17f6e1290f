function yes = isPathOver(arm, path, blocks)
% Returns true if an arm with an open gripper passes over blocks, or beside them, all along a path.
  yes = isempty(blocks);
  if yes, return; end
  c = constants();
  [along, side] = meshgrid([1, 0, -1] * arm.reach, [-0.5, 0, 0.5] * c.clearance.bar(1));
  samples = samplesOf(path);
  of_hand = {};
  for q = samples'
    tool = smileForward(arm.robot, arm.name, q');
    of_hand{end + 1, 1} = tool(1:3, 4)' + along(:) * tool(1:3, 3)' + side(:) * tool(1:3, 2)';
  end
  yes = all(isPointClear(pointsFromWrist(arm, samples), blocks, c.motion_planning.arm_radius)) && ...
        all(isPointClear(vertcat(of_hand{:}), blocks, c.motion_planning.clearance / 2));
end
