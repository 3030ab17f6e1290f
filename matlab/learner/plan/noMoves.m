function moves = noMoves()
% Returns an empty list of moves, a 1x0 struct array: see newMove.
  moves = struct('block', {}, 'goal', {}, 'turns', {}, 'room', {});
end
