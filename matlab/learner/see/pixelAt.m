function pixels = pixelAt(points, eye)
% Returns the pixels, Nx2 [column, row], that show points, Nx3 [units]; they may be outside the picture.
  pixels = floor(toPixel(points, eye)) + 1;
end
