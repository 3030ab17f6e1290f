function state = rememberImpossible(state, k, move, reason)
% Remembers that a move for step k could not be planned, and tells it. That is a fact until something moves:
%   step      number of the step
%   place     of the block, 1x3 [units]
%   isToGoal  false for a temporary placement
%   turns     as in newMove
%   room      which it was to make, 1x3 [units]; [] for none
%   reason    like: there is no room for the fingers
  block = state.known(move.block);
  room = [];
  if ~isempty(move.room), room = move.room.position; end
  state.impossibleMoves(end + 1) = struct('step', k, 'place', block.position, 'isToGoal', ~isempty(move.goal), ...
                                          'turns', move.turns, 'room', room, 'reason', reason);
  name = state.steps(k).name;
  purpose = '';
  if isempty(move.goal), [name, purpose] = deal(nameOf(block, state.steps), ', to be put aside'); end
  text = sprintf('impossible for now: %s%s: %s', name, purpose, reason);
  state.notes(end + 1) = asNote('saw', text);
end
