function rotation = rotationOf(angles)
% Returns the rotation by angles about x, then y, then z [degrees], 3x3: its columns are the axes of the object.
  c = cos(angles * pi / 180);
  s = sin(angles * pi / 180);
  rotation = [c(3), -s(3), 0; s(3), c(3), 0; 0, 0, 1] * [c(2), 0, s(2); 0, 1, 0; -s(2), 0, c(2)] * ...
             [1, 0, 0; 0, c(1), -s(1); 0, s(1), c(1)];
end
