function blocks = detectUnknownObjects(picture, eye, known)
% Detects blocks on the table that are none of the known ones; they belong to no step, but may be in the
% way. Returns a 1xN struct array, see noBlocks.
  blocks = noBlocks();
  table = tableColor(picture);
  for top = segmentTopFaces(picture, table)
    if any(arrayfun(@(other) isTopOf(top, other, eye), known)), continue; end
    for block = measureBlock(top, picture, eye, table)
      if ~any(overlap([block.position(1:2), 0, 0, 0], footprint(known, 0))), blocks(end + 1) = block; end
    end
  end
end

function yes = isTopOf(top, block, eye)
% Returns true if a segmented top face contains the middle of a block's top.
  pixel = pixelAt(block.position + [0, 0, block.size(3) / 2], eye);
  yes = any(top.column == pixel(1) & top.row == pixel(2));
end
