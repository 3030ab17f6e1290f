function pixels = toPixel(points, eye)
% Projects points, Nx3 [units], into the eye's picture: [u, v] from the top left corner, Nx2 [pixels].
  p = (points - eye.pose(1:3, 4)') * eye.pose(1:3, 1:3);
  K = eye.intrinsics;
  pixels = [K(1, 1) * p(:, 1), K(2, 2) * p(:, 2)] ./ p(:, 3) + K(1:2, 3)';
end
