function outline = outlineOf(x, y, area)
% Returns the shape of a top, a triangle, a cross, a ring or any other, in the frame of its object. Multiplying complex numbers adds
% their angles: the k-th powers of points around their middle have a direction, which turns k times as fast as the shape.
% See J. Flusser, "On the independence of rotation moment invariants" (2000).
%   x, y, area  of small pieces of it, Nx1: their places from the object's center, their areas [units, units squared]
%   outline.center   of its middle, 1x2 [units]
%   outline.area     [units squared]
%   outline.spread   root of the mean squared distance from its middle [units]
%   outline.moments  means of the powers of constants().outlines.powers, relative to those of the distances, 1xN complex
%   outline.fold     number of turns after which it looks the same in one full turn; 0 for all of them
%   outline.inside   some points well inside, Nx2 [units], see pointsInside; [] if they are not needed
  c = constants().outlines;
  total = sum(area);
  outline.center = [sum(x .* area), sum(y .* area)] / total;
  outline.area = total;
  z = x - outline.center(1) + 1i * (y - outline.center(2));
  outline.spread = sqrt(sum(area .* abs(z) .^ 2) / total);
  outline.moments = arrayfun(@(k) sum(area .* z .^ k) / sum(area .* abs(z) .^ k), c.powers(:)');
  outline.fold = 0;
  for k = c.powers(abs(outline.moments(:)) > c.symmetric)', outline.fold = gcd(outline.fold, k); end
  outline.inside = [];
end
