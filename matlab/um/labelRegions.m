function number = labelRegions(mask)
% Numbers the connected regions of a picture's pixels: 0 where the mask is false. Instead of a mask it
% may be whole numbers; then the pixels of a region have all the same.
  number = zeros(size(mask));
  if ~any(mask(:)), return; end
  % First pixels that lie upon each other: much fewer such columns than pixels are left to be joined.
  begins = [true(1, size(mask, 2)); mask(2:end, :) ~= mask(1:end - 1, :)];
  run = reshape(cumsum(begins(:)), size(mask));
  left = run(:, 1:end - 1);
  right = run(:, 2:end);
  touch = mask(:, 1:end - 1) == mask(:, 2:end) & mask(:, 2:end) ~= 0;
  n = run(end);
  touching = sparse(left(touch), right(touch), 1, n, n);
  % Rows and columns of a matrix that belong together come out as its blocks.
  [order, ~, first] = dmperm(touching + touching' + speye(n));
  region = zeros(n, 1);
  region(order) = cumsum(accumarray(first(1:end - 1)', 1, [n, 1]));
  inside = mask ~= 0;
  [~, ~, number(inside)] = unique(region(run(inside)));
end
