function block = measureBySilhouette(color, row, column, count, eye)
% Measures the block on the table that has a top, by how many pixels show it, with its sides; a 1x0 struct array if there is
% none. Its sizes are the simplest that agree with the picture: parallel to its rows, an edge may be half a pixel off, that is
% several percent of a side.
%   row, column  pixels of the top, Nx1
%   count        number of pixels of top and sides
  c = constants();
  block = noBlocks();
  low = c.watching.heights(1);
  high = c.watching.heights(2);
  while high - low > c.watching.height_accuracy
    middle = (low + high) / 2;
    if areaUnder(row, column, middle, eye) < count, low = middle; else, high = middle; end
  end
  face = faceAt(row, column, low, eye);
  is_none = face.misfit > c.perception.misfit || face.isRound || low < c.perception.on_table || ...
            high == c.watching.heights(2);
  if is_none, return; end
  % Of the directions of the picture, the one in which a pixel covers most.
  [x, y] = ontoPlane(row, column, eye, low);
  [x_below, y_below] = ontoPlane(row + 1, column, eye, low);
  pixel = median(hypot(x_below - x, y_below - y));
  growth = areaUnder(row, column, low + pixel, eye) - areaUnder(row, column, low, eye);
  width = max(column) + 1 - min(column);
  height = simplest(low, c.watching.edge_pixels * pixel * width / growth);
  face = longerSideFirst(faceAt(row, column, height, eye));
  sides = arrayfun(@(it) simplest(it, c.watching.edge_pixels * pixel), face.sides);
  block = newBlock(color, [sides, height], [face.center, height / 2], face.yaw);
end

function area = areaUnder(row, column, top, eye)
% Returns the area [pixels] of the silhouette of a block on the table that has a top of some pixels at a height.
  face = faceAt(row, column, top, eye);
  block = newBlock([], [face.sides, top], [face.center, top / 2], face.yaw);
  area = areaOf(hull(toPixel(cornersOf(block), eye)));
end

function face = faceAt(row, column, height, eye)
% Returns the face that pixels show if they are at a height: see fitFace.
  [x, y, area] = ontoPlane(row, column, eye, height);
  face = fitFace(x, y, area);
end
