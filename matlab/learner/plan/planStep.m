function [actions, state, reason] = planStep(state, k, free, is_last_resort, eye, arms, sensor)
% Plans the first possible of the moves that may come next for step k: a 1xN cell of actions; {} and a reason if
% there is none.
%   free            numbers of the known blocks that are in no step's place
%   is_last_resort  whether no other step can be done either
  c = constants().task_planning;
  actions = {};
  reason = 'no matching block is visible';
  if state.attempts(k) >= c.max_attempts
    reason = sprintf('%d attempts failed', c.max_attempts);
    return
  elseif state.numTemporary >= c.max_temporary_placements
    reason = sprintf('blocks were put aside %d times already', c.max_temporary_placements);
    return
  end
  state = forgetIfMoved(state);
  for move = movesFor(state, k, free, is_last_resort, eye, arms, sensor)
    if numFailures(state, state.known(move.block)) >= c.max_failed_grasps
      reason = sprintf('%d grasps of a block failed', c.max_failed_grasps);
      continue
    end
    reason = whyImpossible(state, k, move);
    if ~isempty(reason), continue; end
    [actions, place, why, reason] = planMove(state, k, move, eye, arms, sensor);
    if isempty(actions)
      state = rememberImpossible(state, k, move, reason);
      continue
    end
    is_temporary = ~isempty(why);
    state.numTemporary = state.numTemporary + is_temporary;
    state.attempts(k) = state.attempts(k) + ~is_temporary;
    from = state.known(move.block);
    if is_temporary, state.left(end + 1) = from; end
    if is_temporary && isempty(move.goal), state.asides(end + 1) = struct('step', k, 'place', place); end
    is_meant = isMeant(state.meant, from);
    state.meant(is_meant, :) = repmat(place.position, sum(is_meant), 1);
    state.known(move.block) = [];
    state.known = [state.known, place];
    held = actions{find(cellfun(@(it) isfield(it, 'grasp'), actions), 1)};
    state.grasp = held.grasp;
    state.moved = state.steps(k).name;
    if isempty(move.goal) && isempty(move.turns), state.moved = nameOf(from, state.steps); end
    state.notes(end + 1) = actionNote(state.moved, from, move, place, why, held);
    return
  end
end

function moves = movesFor(state, k, free, is_last_resort, eye, arms, sensor)
% Returns the moves that may come next for step k, the best first: a 1xN struct array, see newMove.
  if waitsForSupport(state, k)
    % What it stands on was taken down, because it left no room for fingers at its block: that goes elsewhere.
    moves = noMoves();
    for i = free
      block = state.known(i);
      is_covered = hasObjectsOn(block, state.known(free));
      if isSameKind(block, state.steps(k)) && ~is_covered, moves(end + 1) = newMove(i); end
    end
    return
  end
  moves = [uncoveringMoves(state, free, eye), proposeMoves(state, k, free)];
  opening = max([arms.opening]) - constants().arms.opening_margin;
  moves = [moves, turningMoves(state.steps(k), state.known, free, opening)];
  moves = [moves, clearingMoves(state, moves, free), movesFromPush(state, state.steps(k), free, arms)];
  if ~is_last_resort, return; end
  % Room for the hand at its place, on the table, and for fingers beside what is built.
  moves = [moves, movesFromPlace(state.steps(k), state.known, free)];
  moves = [moves, roomMoves(state, k, moves, free, arms, eye, sensor)];
  moves = [moves, clearingMoves(state, moves, 1:numel(state.known))];
end

function count = numFailures(state, block)
% Returns the number of failed grasps of a block at its place.
  near = constants().motion_planning.same_place_distance;
  at = heldPart(block).position;
  count = sum(arrayfun(@(grasp) norm(grasp.position - at) < near, state.failures));
end
