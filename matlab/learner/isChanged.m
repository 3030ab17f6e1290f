function yes = isChanged(press, alignment, points, shown)
% Returns which of N points, Nx3, a press changed in the demonstration: Nx1 logical.
%   shown  the eye of the demonstration
  [pixels, inside] = pixelsOf(alignedPoints(alignment, points), shown, size(press.changed));
  yes = press.changed(pixels) & inside;
end
