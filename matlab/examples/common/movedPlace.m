function place = movedPlace(place, x, y)
% Returns the place at x, y from the middle of a place, in the same directions.
  point = pointAt(place, x, y, 0);
  place.middle = point(1:2);
end
