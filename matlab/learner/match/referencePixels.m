function pixels = referencePixels(picture, mask)
% Returns one of the pixels of a mask for each of their frequent colors, the one in the middle: 2xN, rows and columns.
  [column, row] = find(mask');
  colors = round(colorsOf(picture, sub2ind(size(mask), row, column)) * 255);
  [~, ~, which] = unique(colors, 'rows');
  [~, order] = sort(-accumarray(which, 1));
  pixels = zeros(2, 0);
  for k = order(1:min(constants().alignment.num_references, end))'
    r = row(which == k);
    c = column(which == k);
    [~, middle] = min(hypot(r - mean(r), c - mean(c)));
    pixels(:, end + 1) = [r(middle); c(middle)];
  end
end
