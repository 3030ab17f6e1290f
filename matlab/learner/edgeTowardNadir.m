function [u, v, step] = edgeTowardNadir(top, eye)
% Returns the pixel, u and v, where a top ends below its middle: on the line to the nadir, the image point
% straight below the camera; and half a pixel along this line, 1x2.
%   top  as from segmentTopFaces
  nadir = toPixel(eye.pose(1:3, 4)' - [0, 0, 1], eye);
  u = mean(top.column) - 0.5;
  v = mean(top.row) - 0.5;
  step = 0.5 * (nadir - [u, v]) / norm(nadir - [u, v]);
  while any(top.column == ceil(u) & top.row == ceil(v))
    u = u + step(1);
    v = v + step(2);
  end
end
