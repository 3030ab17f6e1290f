function points = pointsBetween(ends, number)
% Returns a number of points, at equal distances, on each of the straight lines from one end to the next: Nx3 for the ends Mx3; for
% several rows of ends, Mx3xN, those on all of them.
  fractions = linspace(0, 1, number)';
  in_rows = @(it) reshape(permute(it, [1, 3, 2]), [], 3);
  points = kron(in_rows(ends(1:end - 1, :, :)), ones(number, 1)) + kron(in_rows(diff(ends, 1, 1)), fractions);
end
