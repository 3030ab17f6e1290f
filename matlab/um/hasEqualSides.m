function yes = hasEqualSides(block)
% Whether the sides of a block's top are equally long, as far as pictures can tell: then it looks the same
% every 90 degrees, and can be held either way.
  yes = block.size(1) < constants().blocks.equal_sides * block.size(2);
end
