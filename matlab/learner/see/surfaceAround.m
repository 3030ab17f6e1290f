function surface = surfaceAround(surface, center, radius, most)
% Returns those points of a surface (see surfaceOf) that are near a place, and evenly chosen, about as many as wanted.
%   center  1x2 or 1x3 [units]
  near = find(hypot(surface.points(:, 1) - center(1), surface.points(:, 2) - center(2)) < radius);
  surface = partOfSurface(surface, near(1:max(1, floor(numel(near) / most)):end));
end
