function pixel = toPixel(point, eye)
% Where the eye sees a point, 1x3 [units], in its picture: [u, v] from the top left corner [pixels].
  seen = eye.pose(1:3, 1:3)' * (point(:) - eye.pose(1:3, 4));
  pixel = [eye.intrinsics(1, 1) * seen(1), eye.intrinsics(2, 2) * seen(2)] / seen(3) + ...
          eye.intrinsics(1:2, 3)';
end
