function blocks = detectUnknownObjects(picture, eye, known, heights, tops)
% Detects blocks that are none of the known ones; they belong to no step, but may be in the way. Without
% heights, as from heightMap, only those on the table. Returns a 1xN struct array, see newBlock.
%   tops  what segmentTopFaces found in the picture; omitted if that is not known yet
  if nargin < 4, heights = []; end
  blocks = noBlocks();
  known = spaceOf(known);
  table = tableColor(picture);
  if nargin < 5, tops = segmentTopFaces(picture, table, heights); end
  for top = tops
    if any(arrayfun(@(other) isTopOf(top, other, eye, heights), known)), continue; end
    for block = measureBlock(top, picture, eye, table, heights)
      beside = known(arrayfun(@(other) isBeside(other, block), known));
      if ~any(overlap([block.position(1:2), 0, 0, 0], footprint(beside, 0))), blocks(end + 1) = block; end
    end
  end
end

function yes = isBeside(other, block)
% Returns true if two blocks have parts at the same height.
  apart = abs(other.position(3) - block.position(3)) - (other.size(3) + block.size(3)) / 2;
  yes = apart < -constants().perception.on_table;
end

function yes = isTopOf(top, block, eye, heights)
% Returns true if a segmented top face contains the middle of a block's top.
  middle = block.position + [0, 0, block.size(3) / 2];
  pixel = pixelAt(middle, eye);
  yes = any(top.column == pixel(1) & top.row == pixel(2));
  if yes && ~isempty(heights)
    yes = abs(heights(pixel(2), pixel(1)) - middle(3)) < constants().perception.height_step;
  end
end
