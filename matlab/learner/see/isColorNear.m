function yes = isColorNear(picture, color, pixel)
% Returns true if a color, 1x3, appears within some distance of a pixel, [u, v]; false for one outside the picture.
  shape = [size(picture, 2), size(picture, 1)];
  yes = ~any(pixel < 1 | pixel > shape);
  if ~yes, return; end
  near = constants().perception.near_pixels;
  low = max(pixel - near, 1);
  high = min(pixel + near, shape);
  yes = any(any(colorMask(picture(low(2):high(2), low(1):high(1), :), color)));
end
