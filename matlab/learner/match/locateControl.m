function alignment = locateControl(press, picture, heights, eye, shown)
% Finds how the scene lies in the demonstration around a control before its first press: see align. [] if it is not there.
%   heights  as from heightMap
%   shown    the eye of the demonstration
  c = constants().presses;
  surface = surfaceOf(picture, heights, eye);
  [score, alignment] = align(surface, press.before, shown, press.changed);
  if score <= c.min_agreement || coveredShare(press, alignment, surface, shown) <= c.min_covered, alignment = []; end
end

function share = coveredShare(press, alignment, surface, shown)
% Returns the fraction of what the demonstration shows around a control, in cells of some pixels, that the scene shows as
% well.
  c = constants().presses;
  [pixels, inside] = pixelsOf(alignedPoints(alignment, surface.points), shown, size(press.changed));
  alike = inside & isAlike(colorsOf(press.before, pixels), surface.colors);
  seen = false(size(press.changed));
  seen(pixels(alike)) = true;
  cells = cellsOf(press.changed);
  [row, column] = find(cells);
  around = false(size(cells));
  low = max([min(row), min(column)] - c.around_cells, 1);
  high = min([max(row), max(column)] + c.around_cells, size(cells));
  around(low(1):high(1), low(2):high(2)) = true;
  around = around & cellsOf(~colorMask(press.before, tableColor(press.before)));
  share = nnz(cellsOf(seen) & around) / nnz(around);
end

function cells = cellsOf(mask)
% Returns which square cells of a mask contain something.
  n = constants().presses.cell_pixels;
  shape = floor(size(mask) / n);
  parts = reshape(mask(1:n * shape(1), 1:n * shape(2)), n, shape(1), n, shape(2));
  cells = reshape(any(any(parts, 1), 3), shape);
end
