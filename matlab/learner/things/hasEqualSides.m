function yes = hasEqualSides(block)
% Returns true if the sides of a block's top are equal within the accuracy of pictures: then it looks the
% same every 90 degrees, and can be held either way.
  yes = block.size(1) < constants().blocks.equal_sides * block.size(2);
end
