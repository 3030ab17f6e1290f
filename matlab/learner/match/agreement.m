function share = agreement(surface, alignment, picture, eye)
% Returns the fraction of a surface (see surfaceOf) that looks in a picture of the demonstration as it does in the scene.
  [pixels, inside] = pixelsOf(alignedPoints(alignment, surface.points), eye, size(picture));
  share = mean(isAlike(colorsOf(picture, pixels), surface.colors) & inside);
end
