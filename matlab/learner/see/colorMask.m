function mask = colorMask(picture, color)
% Returns the mask, HxW logical, of the pixels that have a color, 1x3. In the robot's eye each face of a
% block has one flat color: its true color on top, darker ones at the sides.
  c = constants().perception;
  tolerance = c.color_tolerance + c.color_tolerance_bright * max(color);
  mask = abs(picture(:, :, 1) - color(1)) < tolerance & abs(picture(:, :, 2) - color(2)) < tolerance & ...
         abs(picture(:, :, 3) - color(3)) < tolerance;
end
