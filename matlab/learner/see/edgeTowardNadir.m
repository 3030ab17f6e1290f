function [u, v, step] = edgeTowardNadir(top, eye)
% Returns the pixel, u and v, where a top ends below its middle: on the line to the nadir, the image point
% straight below the camera; and half a pixel along this line, 1x2. It may leave the top and meet it again, as at a corner.
%   top  as from segmentTopFaces
  nadir = toPixel(eye.pose(1:3, 4)' - [0, 0, 1], eye);
  at = [mean(top.column), mean(top.row)] - 0.5;
  step = 0.5 * (nadir - at) / norm(nadir - at);
  u = at(1);
  v = at(2);
  low = [min(top.column), min(top.row)] - 1;
  high = [max(top.column), max(top.row)];
  while all(at > low & at <= high)
    is_top = any(top.column == ceil(at(1)) & top.row == ceil(at(2)));
    at = at + step;
    if is_top
      u = at(1);
      v = at(2);
    end
  end
end
