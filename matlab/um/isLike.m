function yes = isLike(block, step)
% Whether a block that was seen may play the part of a step's.
  yes = sameColor(step.color, block.color) && sameSize(step.size, block.size);
end
