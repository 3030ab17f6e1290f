function yes = isSideAt(picture, eye, point)
% Returns true if what a picture shows at a point, 1x3, is a side of what rises above it: below a brighter area of its hue.
  [color, pixel] = colorAt(picture, eye, point);
  number = labelRegions(colorMask(picture, color));
  inside = find(number == number(pixel(2), pixel(1)));
  inside = inside(mod(inside - 1, size(picture, 1)) > 0);
  flat = round(255 * reshape(picture, [], 3)) * [65536; 256; 1];
  above = flat(inside - 1);
  above = above(above ~= round(255 * color) * [65536; 256; 1]);
  yes = ~isempty(above);
  if yes
    code = mode(above);
    yes = isDarkerShade(color, [floor(code / 65536), mod(floor(code / 256), 256), mod(code, 256)] / 255);
  end
end
