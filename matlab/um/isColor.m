function mask = isColor(picture, color)
% The pixels of a color, 1x3. In the robot's eye each face of a block has one flat color: the true one
% on top, darker ones at the sides.
  c = constants().see;
  tolerance = c.color_tolerance + c.color_tolerance_bright * max(color);
  mask = abs(picture(:, :, 1) - color(1)) < tolerance & abs(picture(:, :, 2) - color(2)) < tolerance & ...
         abs(picture(:, :, 3) - color(3)) < tolerance;
end
