function [pixels, inside] = pixelsOf(points, eye, shape)
% Returns the numbers of the pixels in a picture of a shape [height, width] that show points, Nx3 [units], and which of the
% points are inside it, Nx1 logical; the pixel of the others is the first.
  at = pixelAt(points, eye);
  inside = at(:, 1) >= 1 & at(:, 1) <= shape(2) & at(:, 2) >= 1 & at(:, 2) <= shape(1);
  pixels = ones(rows(at), 1);
  pixels(inside) = at(inside, 2) + shape(1) * (at(inside, 1) - 1);
end
