function yes = isSameKind(block, step)
% Returns true if a detected block has the color, the form and the size of a step, or of a kind of blocks;
% for things of several colors, the same parts.
  if isempty(block.parts) && isempty(step.parts)
    yes = sameColor(step.color, block.color) && sameForm(step, block);
  else
    yes = hasPartsOf(block, step, true);
  end
end
