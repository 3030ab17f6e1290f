function [first, last, number] = strokesOf(hand, turns)
% Returns the angles of the last joint at which a stroke of some turns (see newPress) begins and ends, and how many there are:
% the tool fits into the head of a fastener only after some turning.
%   hand  see drivingHand
  stroke = hand.clockwise;
  if turns.isLoosening, stroke = -stroke; end
  first = hand.middle - stroke / 2;
  last = hand.middle + stroke / 2;
  number = turns.number * hand.strokesPerTurn + ~turns.isLoosening;
end
