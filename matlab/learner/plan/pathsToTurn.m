function paths = pathsToTurn(hand, turns, height, q)
% Returns the paths over a fastener, to where the strokes begin, and of a stroke: down, turning, up, back; a 1x6 cell, {} if the
% arm of a hand (see drivingHand) cannot.
%   turns   see newPress; height: of the center of the tool on the way [units]
%   q       joint angles before, 1xn [rad]
  paths = {};
  [first, last] = strokesOf(hand, turns);
  over = poseOver(hand, turns.place, height);
  across = pathOver(hand.arm, q, over);
  if isempty(across), return; end
  begin = moveJoints(hand.arm, [across.positions(end, :); across.positions(end, 1:end - 1), first]);
  down = turningLine(hand.arm, begin, poseOver(hand, turns.place, turns.place(3)));
  if isempty(down), return; end
  turn = moveJoints(hand.arm, [down.positions(end, :); down.positions(end, 1:end - 1), last]);
  up = turningLine(hand.arm, turn, over);
  if isempty(up), return; end
  paths = {across, begin, down, turn, up, moveJoints(hand.arm, [up.positions(end, :); begin.positions(end, :)])};
end
