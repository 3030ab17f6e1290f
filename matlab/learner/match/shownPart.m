function [seen, before, later] = shownPart(mask, press, alignment, surface, shown)
% Returns the part of a surface (see surfaceOf) that a mask of the pixels of the demonstration shows, its colors before a
% press, and those after, Nx3.
%   mask   HxW logical
%   shown  the eye of the demonstration
  seen = partOfSurface(surface, isWithin(mask, alignment, surface.points, shown));
  pixels = pixelsOf(alignedPoints(alignment, seen.points), shown, size(mask));
  before = colorsOf(press.before, pixels);
  later = colorsOf(press.later, pixels);
end
