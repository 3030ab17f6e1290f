function number = labelRegions(mask)
% Numbers the connected regions of a picture's pixels: 0 where the mask is false.
  number = zeros(size(mask));
  pixels = find(mask);
  index = number;
  index(pixels) = 1:numel(pixels);
  down = index(1:end - 1, :) > 0 & index(2:end, :) > 0;
  right = index(:, 1:end - 1) > 0 & index(:, 2:end) > 0;
  upper = index(1:end - 1, :);
  lower = index(2:end, :);
  left = index(:, 1:end - 1);
  next = index(:, 2:end);
  n = numel(pixels);
  touching = sparse([upper(down); left(right)], [lower(down); next(right)], 1, n, n);
  % Rows and columns of a matrix that belong together come out as its blocks.
  [order, ~, first] = dmperm(touching + touching' + speye(n));
  for k = 1:numel(first) - 1
    number(pixels(order(first(k):first(k + 1) - 1))) = k;
  end
end
