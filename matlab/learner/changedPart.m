function [seen, before, later] = changedPart(press, alignment, surface, shown)
% Returns the part of a surface (see surfaceOf) that a press changed in the demonstration, its colors before, and those
% after, Nx3.
%   shown  the eye of the demonstration
  [pixels, inside] = pixelsOf(alignedPoints(alignment, surface.points), shown, size(press.changed));
  is_part = press.changed(pixels) & inside;
  seen = partOfSurface(surface, is_part);
  before = colorsOf(press.before, pixels(is_part));
  later = colorsOf(press.later, pixels(is_part));
end
