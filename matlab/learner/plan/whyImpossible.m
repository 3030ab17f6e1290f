function reason = whyImpossible(state, k, move)
% Returns why a move for step k is known to be impossible, as from rememberImpossible; '' if it is not known.
  reason = '';
  near = constants().task_planning.unmoved_distance;
  block = state.known(move.block);
  for it = state.impossibleMoves
    is_about = it.step == k && it.isToGoal == ~isempty(move.goal) && isequal(it.turns, move.turns) && ...
               norm(it.place - block.position) < near && isempty(it.room) == isempty(move.room);
    if is_about && (isempty(it.room) || norm(it.room - move.room.position) < near)
      reason = it.reason;
      return
    end
  end
end
