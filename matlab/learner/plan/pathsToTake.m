function paths = pathsToTake(hand, tool, height, turns, start, q)
% Returns the paths over a tool, down to it, and up again: a 1x3 cell; {} if the arm of a hand (see drivingHand) cannot.
%   height  of the center of the tool on the way [units]
%   turns   the first of those that follow
%   start   joint angles from which to search, 1xn [rad]; q: those of the arm
  paths = {};
  over = poseOver(hand, tool.position, height);
  iterations = constants().motion_planning.ik_iterations;
  first = armInverse(hand.arm, over, start, 'anyTurn', true, 'maxIterations', iterations);
  if isempty(first), return; end
  way = moveJoints(hand.arm, [q; first(1:end - 1), strokesOf(hand, turns)]);
  down = turningLine(hand.arm, way, poseOver(hand, tool.position, tool.position(3)));
  if isempty(down), return; end
  up = turningLine(hand.arm, down, over);
  if ~isempty(up), paths = {way, down, up}; end
end
