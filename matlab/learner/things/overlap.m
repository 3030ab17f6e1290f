function yes = overlap(some, many)
% Returns which of N rectangles overlap with which of M others: NxM logical.
%   some  the M others, Mx5: see footprint
%   many  the N rectangles, Nx5
% Separating axes: two rectangles are apart if there is a gap between them in the direction of a side.
  yes = true(size(many, 1), size(some, 1));
  if isempty(yes), return; end
  some = some';
  % The offsets of the centers, NxM, and the extents of one rectangle along the sides of the other.
  x = many(:, 1) - some(1, :);
  y = many(:, 2) - some(2, :);
  angle = many(:, 5) - some(5, :);
  c = abs(cos(angle)) / 2;
  s = abs(sin(angle)) / 2;
  % In the frames of `some`, then in those of `many`.
  cosine = cos(some(5, :));
  sine = sin(some(5, :));
  yes = abs(x .* cosine + y .* sine) < some(3, :) / 2 + many(:, 3) .* c + many(:, 4) .* s & ...
        abs(y .* cosine - x .* sine) < some(4, :) / 2 + many(:, 3) .* s + many(:, 4) .* c;
  if ~any(yes(:)), return; end
  cosine = cos(many(:, 5));
  sine = sin(many(:, 5));
  yes = yes & abs(x .* cosine + y .* sine) < many(:, 3) / 2 + some(3, :) .* c + some(4, :) .* s & ...
        abs(y .* cosine - x .* sine) < many(:, 4) / 2 + some(3, :) .* s + some(4, :) .* c;
end
