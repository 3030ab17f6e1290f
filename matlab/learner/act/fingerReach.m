function reach = fingerReach(arm)
% Returns how far the fingers reach below the tool when they point straight down: the height of the tool
% at which they touch the table, found by bisection.
  accuracy = constants().arms.reach_accuracy;
  tool = smileForward(arm.robot, arm.name, arm.ready);
  over = tool(1:3, 4)';
  touching = 0;
  free = over(3);
  while free - touching > accuracy / 4
    height = (touching + free) / 2;
    q = armInverse(arm, toolPose(arm, [over(1:2), height], 0, 0), arm.ready, 'anyTurn', true);
    if ~isempty(q) && isValidAt(arm, q), free = height; else, touching = height; end
  end
  reach = round(free / accuracy) * accuracy;
end
