function [color, spot] = colorAt(picture, eye, point)
% The color that a picture shows at a point, 1x3 [units], and at which pixel, [u, v]; [] if the point is
% outside the picture, or there is no picture.
  color = [];
  spot = pixelAt(point, eye);
  if isempty(picture) || any(spot < 1 | spot > [size(picture, 2), size(picture, 1)]), return; end
  color = reshape(picture(spot(2), spot(1), 1:3), 1, 3);
end
