function moves = clearingMoves(state, moves, free)
% Returns the moves of blocks that leave no room for the fingers at the blocks of other moves: a 1xN struct
% array as from proposeMoves, first of those that are alone in the way, then of the closest.
%   free  numbers of the known blocks that are in no step's place
  known = state.known;
  alone = zeros(1, 0);
  closest = zeros(1, 0);
  blocks = arrayfun(@(move) move.block, moves);
  for k = unique(blocks(:)', 'stable')
    others = setdiff(1:numel(known), k);
    if ~isempty(graspYaws(known(k), known(others))), continue; end
    is_free = arrayfun(@(i) i ~= k && isClose(known(i), known(k)) && ...
                            ~hasObjectsOn(known(i), known(free)), free);
    beside = free(is_free);
    [~, order] = sort(arrayfun(@(i) norm(known(i).position - known(k).position), beside));
    beside = beside(order);
    closest = [closest, beside(1:min(1, end))];
    for i = beside(1:min(constants().task_planning.max_beside, end))
      if ~isempty(graspYaws(known(k), known(setdiff(others, i)))), alone(end + 1) = i; end
    end
  end
  moves = noMoves();
  for i = unique([alone, closest], 'stable'), moves(end + 1) = newMove(i); end
end
