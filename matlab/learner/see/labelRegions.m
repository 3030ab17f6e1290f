function number = labelRegions(mask, heights)
% Labels the connected regions of a mask, HxW logical: 0 where it is false, otherwise numbers from 1. The
% mask may also contain whole numbers; then all pixels of a region have the same one. With heights, as from
% heightMap, a step between two pixels separates regions.
  if nargin < 2, heights = []; end
  number = zeros(size(mask));
  rows = find(any(mask, 2));
  columns = find(any(mask, 1));
  if isempty(rows), return; end
  % Most masks fill a small part of the picture.
  rows = rows(1):rows(end);
  columns = columns(1):columns(end);
  if ~isempty(heights), heights = heights(rows, columns); end
  number(rows, columns) = labelsWithin(mask(rows, columns), heights);
end

function number = labelsWithin(mask, heights)
  number = zeros(size(mask));
  % First join pixels in columns to runs: there are far fewer runs than pixels.
  in_column = mask(2:end, :) == mask(1:end - 1, :);
  touch = mask(:, 1:end - 1) == mask(:, 2:end) & mask(:, 2:end) ~= 0;
  if ~isempty(heights)
    step = constants().perception.height_step;
    in_column = in_column & abs(diff(heights, 1, 1)) < step;
    touch = touch & abs(diff(heights, 1, 2)) < step;
  end
  begins = [true(1, size(mask, 2)); ~in_column];
  run = reshape(cumsum(begins(:)), size(mask));
  left = run(:, 1:end - 1);
  right = run(:, 2:end);
  n = run(end);
  touching = sparse(left(touch), right(touch), 1, n, n);
  % The block triangular form of the adjacency matrix has one block for each connected component.
  [order, ~, first] = dmperm(touching + touching' + speye(n));
  region = zeros(n, 1);
  region(order) = cumsum(accumarray(first(1:end - 1)', 1, [n, 1]));
  inside = mask ~= 0;
  [~, ~, number(inside)] = unique(region(run(inside)));
end
