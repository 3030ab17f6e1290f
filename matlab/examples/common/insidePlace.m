function xy = insidePlace(place, points)
% Returns x, y (Nx2) of points of the world as seen from the middle of a place.
  xy = (points(:, 1:2) - place.middle) * [place.x(1:2)', place.y(1:2)'];
end
