function note = actionNote(name, block, move, place, why, held)
% Returns a note about an action that makes a move (see newMove) of a block, of a name, to a place.
%   why   it is brought there; empty for its goal
%   held  the action that takes it, or pushes it
  verb = 'carries';
  if strcmp(held.kind, 'push'), verb = 'pushes'; end
  if ~isempty(move.turns), verb = 'turns'; end
  if isDragged(move.goal), verb = 'drags'; end
  if ~isempty(why), why = [', ' why]; end
  text = sprintf('%s %s from (%.2f, %.2f) to (%.2f, %.2f)%s, with arm %s', verb, name, ...
                 block.position(1:2), place.position(1:2), why, held.arm.name);
  note = asNote('action', text, place);
end
