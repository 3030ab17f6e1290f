function yes = isForearmClear(robot, arm, q, blocks)
% Returns true if the forearm of an arm that holds its tool straight down avoids blocks. (graspYaws checks
% the gripper.)
%   arm  1 left, 2 right
%   q    its joint angles, 1x7 [rad]
  c = constants().motion_planning;
  names = {'left', 'right'};
  tool = smileForward(robot, names{arm}, q);
  jacobian = smileJacobian(robot, names{arm}, q);
  wrist = tool(1:3, 4)' + [0, 0, c.wrist_above_tool];
  along = -c.forearm_length * jacobian(4:6, 5)';  % joint W0 turns about the forearm
  tops = arrayfun(@(block) block.position(3) + block.size(3) / 2, blocks(:));
  covered = footprint(blocks, c.forearm_radius);
  yes = true;
  for fraction = (0:c.forearm_steps) / c.forearm_steps
    point = wrist + fraction * along;
    low = tops > point(3) - c.forearm_radius;
    yes = yes && ~any(overlap([point(1:2), 0, 0, 0], covered(low, :)));
  end
end
