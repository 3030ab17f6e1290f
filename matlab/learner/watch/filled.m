function pixels = filled(polygon, shape)
% Returns the numbers of the pixels in a convex polygon, Nx2 points u, v from the top left corner, in a picture of a shape
% [height, width]: Mx1.
  low = max(floor(min(polygon, [], 1)), 0);
  high = min(ceil(max(polygon, [], 1)), shape([2, 1]));
  [column, row] = meshgrid(low(1):high(1) - 1, low(2):high(2) - 1);
  inside = true(size(row));
  polygon = hull(polygon);
  next = polygon([2:end, 1], :);
  for k = 1:rows(polygon)
    a = polygon(k, :);
    side = next(k, :) - a;
    inside = inside & side(1) * (row + 0.5 - a(2)) >= side(2) * (column + 0.5 - a(1));
  end
  pixels = 1 + row(inside) + shape(1) * column(inside);
end
