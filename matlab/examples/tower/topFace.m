function mask = topFace(image, hue)
% The pixels of a block's top: those of its hue that are fully bright. In the robot's eye each face has
% one flat color, the true one on top and darker ones at the sides.
  hsv = rgb2hsv(image);
  far = abs(hsv(:, :, 1) - hue);
  far = min(far, 1 - far);  % hue goes round in a circle
  mask = far < 0.03 & hsv(:, :, 2) > 0.8 & hsv(:, :, 3) > 0.95;
end
