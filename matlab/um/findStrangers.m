function blocks = findStrangers(picture, eye, known)
% Blocks on the table that are none of those known: nobody wants them, but they may be in the way.
  blocks = noBlocks();
  table = tableColor(picture);
  for top = topsIn(picture, table)
    for block = measureBlock(top, picture, eye, table)
      if ~any(overlap([block.position(1:2), 0, 0, 0], footprint(known, 0))), blocks(end + 1) = block; end
    end
  end
end
