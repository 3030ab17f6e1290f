function support = supportOf(block)
% What a block stands on that is not on the table, as if it were one block: something must be there, even
% if it hides it.
  support = noBlocks();
  bottom = block.position(3) - block.size(3) / 2;
  if bottom < constants().decide.stands_high, return; end
  support(1) = block;
  support.size(3) = bottom;
  support.position(3) = bottom / 2;
end
