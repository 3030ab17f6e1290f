function yes = isSameKind(block, step)
% Returns true if a detected block has the color, the form and the size of a step, or of a kind of blocks.
  yes = sameColor(step.color, block.color) && sameForm(step, block);
end
