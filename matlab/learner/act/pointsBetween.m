function points = pointsBetween(ends, number)
% Returns a number of points, at equal distances, on each of the straight lines from one end to the next: Nx3 for the ends Mx3.
  fractions = linspace(0, 1, number)';
  points = kron(ends(1:end - 1, :), ones(number, 1)) + kron(diff(ends, 1, 1), fractions);
end
