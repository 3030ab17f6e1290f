function yes = isWithin(mask, alignment, points, shown)
% Returns which of N points, Nx3, a mask of the pixels of the demonstration shows: Nx1 logical.
%   mask   HxW logical
%   shown  the eye of the demonstration
  [pixels, inside] = pixelsOf(alignedPoints(alignment, points), shown, size(mask));
  yes = mask(pixels) & inside;
end
