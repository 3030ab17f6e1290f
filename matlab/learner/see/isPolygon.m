function yes = isPolygon(x, y, area)
% Returns true if the fifth or sixth powers of points have a direction from their middle, as complex numbers: those of a
% regular pentagon keep 0.31 of it, those of a hexagon 0.24.
%   x, y, area  of small pieces of a top, Nx1 [units, units squared]
  z = x + 1i * y;
  z = z - sum(area .* z) / sum(area);
  yes = any(arrayfun(@(k) abs(sum(area .* z .^ k)) > constants().perception.corners * sum(area .* abs(z) .^ k), [5, 6]));
end
