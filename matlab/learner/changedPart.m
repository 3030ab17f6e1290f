function [seen, before, later] = changedPart(press, alignment, surface, shown)
% Returns the part of a surface (see surfaceOf) that a press changed in the demonstration, its colors before, and those
% after, Nx3.
%   shown  the eye of the demonstration
  seen = partOfSurface(surface, isChanged(press, alignment, surface.points, shown));
  pixels = pixelsOf(alignedPoints(alignment, seen.points), shown, size(press.changed));
  before = colorsOf(press.before, pixels);
  later = colorsOf(press.later, pixels);
end
