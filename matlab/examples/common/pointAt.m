function point = pointAt(place, x, y, z)
% Returns the point (1x3) of the world at x, y from the middle of a place and at the height z.
  point = [place.middle, z] + x * place.x + y * place.y;
end
