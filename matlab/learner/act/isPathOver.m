function yes = isPathOver(arm, path, blocks)
% Returns true if an arm with an open gripper passes over blocks, or beside them, all along a path.
  yes = isempty(blocks);
  if yes, return; end
  c = constants();
  [along, side] = meshgrid([1, 0, -1] * arm.reach, [-0.5, 0, 0.5] * c.clearance.bar(1));
  samples = samplesOf(path);
  tools = smileForward(arm.robot, arm.name, samples);
  of_hand = kron(columnsOf(tools, 4), ones(numel(along), 1)) + kron(columnsOf(tools, 3), along(:)) + ...
            kron(columnsOf(tools, 2), side(:));
  yes = all(isPointClear(pointsFromWrist(arm, samples), blocks, c.motion_planning.arm_radius)) && ...
        all(isPointClear(of_hand, blocks, c.motion_planning.clearance / 2));
end
