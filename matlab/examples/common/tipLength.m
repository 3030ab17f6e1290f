function tip = tipLength(robot, arm)
% Returns how far the fingers of an arm reach below its tool: it is as low over the table as they allow it.
  over = robot.poses.ready(arm, :);
  pose = smileForward(robot, robot.arms{arm}, over);
  for tip = 0:0.02:2
    pose(3, 4) = tip;
    q = smileInverse(robot, robot.arms{arm}, pose, over, 'maxIterations', 300);
    if isempty(q), continue, end
    motion = smileMoveJoints(robot, robot.arms{arm}, q);
    if isempty(smileFirstInvalid(robot, motion, 'table', tableSize())), return, end
  end
  error('the tool cannot point down over the table');
end
