function paths = pathsToPut(hand, tool, height, take, q)
% Returns the paths over the place of a tool, to how the arm took it, down, up, and to where the arm waits: a 1x5 cell; {} if
% the arm of a hand (see drivingHand) cannot.
%   height  of the center of the tool on the way [units]; take: as from pathsToTake
%   q       joint angles before, 1xn [rad]
  paths = {};
  over = poseOver(hand, tool.position, height);
  across = pathOver(hand.arm, q, over);
  if isempty(across), return; end
  adjust = moveJoints(hand.arm, [across.positions(end, :); take{3}.positions(end, :)]);
  low = tool.position(3) + constants().motion_planning.place_height_margin;
  down = turningLine(hand.arm, adjust, poseOver(hand, tool.position, low));
  if isempty(down), return; end
  up = turningLine(hand.arm, down, over);
  if ~isempty(up), paths = {across, adjust, down, up, moveJoints(hand.arm, [up.positions(end, :); hand.arm.parked])}; end
end
