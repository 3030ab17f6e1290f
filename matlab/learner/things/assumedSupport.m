function support = assumedSupport(block)
% Returns the support of a block that does not stand on the table, as one block from the table to its
% bottom: something must carry it, even if it is hidden. A 1x0 struct array for a block on the table.
  support = noBlocks();
  bottom = block.position(3) - block.size(3) / 2;
  if bottom < constants().beliefs.min_support_height, return; end
  support(1) = block;
  support.size(3) = bottom;
  support.position(3) = bottom / 2;
end
