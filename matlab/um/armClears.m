function yes = armClears(robot, arm, q, blocks)
% Whether the forearm of an arm that holds its tool straight down keeps off blocks. (What the hand
% itself needs, fingerTurns knows.)
  hand = 3.11;     % from the tool up to the wrist [units]
  forearm = 3.74;  % from there to the elbow
  radius = 0.65;
  names = {'left', 'right'};
  tool = smileForward(robot, names{arm}, q);
  jacobian = smileJacobian(robot, names{arm}, q);
  wrist = tool(1:3, 4)' + [0, 0, hand];
  along = -forearm * jacobian(4:6, 5)';  % joint W0 turns about the forearm
  tops = arrayfun(@(block) block.position(3) + block.size(3) / 2, blocks(:));
  covered = footprint(blocks, radius);
  yes = true;
  for share = 0:0.1:1
    point = wrist + share * along;
    low = tops > point(3) - radius;
    yes = yes && ~any(overlap([point(1:2), 0, 0, 0], covered(low, :)));
  end
end
