function number = labelRegions(mask)
% Labels the connected regions of a mask, HxW logical: 0 where it is false, otherwise numbers from 1. The
% mask may also contain whole numbers; then all pixels of a region have the same one.
  number = zeros(size(mask));
  rows = find(any(mask, 2));
  columns = find(any(mask, 1));
  if isempty(rows), return; end
  % Most masks fill a small part of the picture.
  rows = rows(1):rows(end);
  columns = columns(1):columns(end);
  number(rows, columns) = labelsWithin(mask(rows, columns));
end

function number = labelsWithin(mask)
  number = zeros(size(mask));
  % First join pixels in columns to runs: there are far fewer runs than pixels.
  begins = [true(1, size(mask, 2)); mask(2:end, :) ~= mask(1:end - 1, :)];
  run = reshape(cumsum(begins(:)), size(mask));
  left = run(:, 1:end - 1);
  right = run(:, 2:end);
  touch = mask(:, 1:end - 1) == mask(:, 2:end) & mask(:, 2:end) ~= 0;
  n = run(end);
  touching = sparse(left(touch), right(touch), 1, n, n);
  % The block triangular form of the adjacency matrix has one block for each connected component.
  [order, ~, first] = dmperm(touching + touching' + speye(n));
  region = zeros(n, 1);
  region(order) = cumsum(accumarray(first(1:end - 1)', 1, [n, 1]));
  inside = mask ~= 0;
  [~, ~, number(inside)] = unique(region(run(inside)));
end
