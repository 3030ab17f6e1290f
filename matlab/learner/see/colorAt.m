function [color, pixel] = colorAt(picture, eye, point)
% Returns the color, 1x3, of the pixel that shows a point, 1x3 [units], and that pixel, [u, v]. The color
% is [] if the point is outside the picture or the picture is [].
  color = [];
  pixel = pixelAt(point, eye);
  if isempty(picture) || any(pixel < 1 | pixel > [size(picture, 2), size(picture, 1)]), return; end
  color = reshape(picture(pixel(2), pixel(1), 1:3), 1, 3);
end
