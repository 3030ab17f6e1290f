function pixel = toPixel(point, eye)
% Projects a point, 1x3 [units], into the eye's picture: [u, v] from the top left corner [pixels].
  p = eye.pose(1:3, 1:3)' * (point(:) - eye.pose(1:3, 4));
  pixel = [eye.intrinsics(1, 1) * p(1), eye.intrinsics(2, 2) * p(2)] / p(3) + ...
          eye.intrinsics(1:2, 3)';
end
