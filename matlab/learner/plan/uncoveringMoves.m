function moves = uncoveringMoves(state, free, eye)
% Returns the moves of blocks that lie on others which were never seen and which the building would hide, as
% long as blocks are missing: a 1xN struct array as from proposeMoves.
%   free  numbers of the known blocks that are in no step's place
  moves = noMoves();
  known = state.known;
  for i = free
    support = assumedSupport(known(i));
    if isempty(support) || hasObjectsOn(known(i), known(free)) || isSupportKnown(known(i), known), continue; end
    if isTopHidden(support, state.steps, eye), moves(end + 1) = newMove(i); end
  end
  if ~isempty(moves) && ~any(arrayfun(@isMissing, state.steps)), moves(:) = []; end

  function yes = isMissing(step)
    fits = known(arrayfun(@(block) isSameKind(block, step), known));
    yes = isempty(fits) || numel(fits) < sum(arrayfun(@(it) isSameKind(fits(1), it), state.steps));
  end
end

function yes = isSupportKnown(block, known)
% Returns true if a block lies on a known one.
  bottom = block.position(3) - block.size(3) / 2;
  tops = arrayfun(@(it) it.position(3) + it.size(3) / 2, known);
  below = known(abs(tops - bottom) < constants().task_planning.max_sinking);
  yes = any(overlap(footprint(block, 0), footprint(below, 0)));
end
