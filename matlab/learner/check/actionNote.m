function note = actionNote(name, block, move, place, is_temporary, arm)
% Returns a note about an action that makes a move (see newMove) of a block, of a name, to a place with an arm: to its
% goal, or, if that is temporary, out of the way, for a handover, or onto another face.
  verb = 'carries';
  if isDragged(move.goal), verb = 'drags'; end
  why = '';
  if is_temporary, why = ', out of the way'; end
  if is_temporary && ~isempty(move.goal), why = ', for the other arm'; end
  if ~isempty(move.turns)
    verb = 'turns';
    why = ', onto another face';
  end
  text = sprintf('%s %s from (%.2f, %.2f) to (%.2f, %.2f)%s, with arm %s', verb, name, ...
                 block.position(1:2), place.position(1:2), why, arm.name);
  note = asNote('action', text, place);
end
