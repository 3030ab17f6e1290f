function mask = maskAround(picture, eye, point)
% Returns the mask, HxW, of what a picture shows at and around a point, 1x3 [units].
  c = constants().uses;
  [x, y] = meshgrid(linspace(-c.around, c.around, c.points_around));
  [pixels, inside] = pixelsOf(point + [x(:), y(:), 0 * x(:)], eye, [size(picture, 1), size(picture, 2)]);
  mask = false(size(picture, 1), size(picture, 2));
  mask(pixels(inside)) = true;
end
