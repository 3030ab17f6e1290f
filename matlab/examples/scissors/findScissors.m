function scissors = findScissors(sensor, aux)
% Returns the place of the scissors on the table: the middle of their grip, whose upper side is 0.8 high; its depth is the
% direction of their blades.
  grip = between(pointsOf([215 38 61], sensor, aux), 0.77, 0.83);
  blades = between(pointsOf([184 190 198], sensor, aux), 0.3, 0.6);
  if size(grip, 1) < 50 || size(blades, 1) < 20, error('no scissors are visible'); end
  [middle, axes] = rectangleAround(grip);
  direction = axes(1, :);
  if (mean(blades(:, 1:2), 1) - middle) * direction' < 0, direction = -direction; end
  scissors = placeAt(middle, direction);
end
