function blocks = findStrangers(picture, eye, known)
% Blocks on the table that are none of those known: nobody wants them, but they may be in the way.
  blocks = noBlocks();
  table = tableColor(picture);
  for top = topsIn(picture, table)
    if any(arrayfun(@(other) isTopOf(top, other, eye), known)), continue; end
    for block = measureBlock(top, picture, eye, table)
      if ~any(overlap([block.position(1:2), 0, 0, 0], footprint(known, 0))), blocks(end + 1) = block; end
    end
  end
end

function yes = isTopOf(top, block, eye)
  spot = pixelAt(block.position + [0, 0, block.size(3) / 2], eye);
  yes = any(top.column == spot(1) & top.row == spot(2));
end
