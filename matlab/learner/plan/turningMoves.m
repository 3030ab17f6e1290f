function moves = turningMoves(step, known, free, opening)
% Returns the moves that turn a block onto another face, if none looks as a step wants it: a 1xN struct array, see newMove,
% first of those that need the fewest turns. Where it cannot be turned, it is put elsewhere.
%   free     numbers of the known blocks that are in no step's place
%   opening  of the widest gripper [units]
  moves = noMoves();
  if isempty(step.startSize) || any(arrayfun(@(it) isSameKind(it, step), known(free))), return; end
  for i = free
    block = known(i);
    if isRound(block) || ~sameColor(step.color, block.color) || hasObjectsOn(block, known(free)), continue; end
    turns = turnsBetween(block.size, step.size, opening);
    if ~isempty(turns) && ~isnan(turns(1)), moves(end + 1) = newMove(i, [], turns); end
  end
  [~, order] = sort(arrayfun(@(move) numel(move.turns), moves));
  moves = moves(order);
  for move = moves, moves(end + 1) = newMove(move.block); end
end
