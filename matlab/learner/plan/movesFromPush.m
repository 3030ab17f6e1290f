function moves = movesFromPush(state, step, free, arms)
% Returns the moves of blocks each of which, alone, keeps an arm from pushing another one to the place of a step, where what is
% built leaves no room for fingers: a 1xN struct array, see newMove.
%   free  numbers of the known blocks that are in no step's place
  known = state.known;
  moves = noMoves();
  built = setdiff(1:numel(known), free);
  % What goes into a container is never pushed there.
  if ~isempty(graspYaws(step, known(built))) || ~isempty(containerAt(state.containers, step.position)), return; end
  is_fit = arrayfun(@(i) isSameKind(known(i), step), free);
  is_near = arrayfun(@(i) isClose(known(i), step), free);
  far = free(is_fit & ~is_near);
  % Blocks far away obstruct nothing, so one of them stands for all.
  for pushed = [free(is_fit & is_near), far(1:min(end, 1))]
    around = setdiff(free(is_near), pushed, 'stable');
    if ~isempty(wayToPush(arms, step, known([built, around])))
      moves = noMoves();
      return
    end
    for i = around
      if hasObjectsOn(known(i), known(free)), continue; end
      way = wayToPush(arms, step, known([built, around(around ~= i)]));
      if ~isempty(way), moves(end + 1) = newMove(i, [], [], roomToPush(arms, way)); end
    end
  end
end
