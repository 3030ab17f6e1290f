function spot = pixelAt(point, eye)
% Column and row of the pixel that shows a point, 1x3 [units]; it may be outside the picture.
  spot = round(toPixel(point, eye) + 0.5);
end
