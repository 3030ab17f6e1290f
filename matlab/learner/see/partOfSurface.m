function surface = partOfSurface(surface, which)
% Returns the points of a surface (see surfaceOf) of a mask, Nx1 logical, or of some numbers.
  surface.points = surface.points(which, :);
  surface.colors = surface.colors(which, :);
end
