function pixel = pixelAt(point, eye)
% Returns the pixel, [column, row], that shows a point, 1x3 [units]; it may be outside the picture.
  pixel = round(toPixel(point, eye) + 0.5);
end
