function moves = movesFromPlace(step, known, free)
% Returns the moves of blocks each of which leaves no room for the hand at the place of a step, though it may be higher than
% the fingers there: a 1xN struct array as from proposeMoves, of the closest first.
%   free  numbers of the known blocks that are in no step's place
  isInWay = @(it) isClose(it, step) && ~hasObjectsOn(it, known(free)) && isempty(graspYaws(step, it)) && ~isSameKind(it, step);
  in_way = free(arrayfun(@(i) isInWay(known(i)), free));
  [~, order] = sort(arrayfun(@(i) norm(known(i).position - step.position), in_way));
  moves = noMoves();
  for i = in_way(order), moves(end + 1) = newMove(i); end
end
