function place = findPlace(name, color, height, sensor, aux)
% Returns the place of what has upper faces of a color at a height. Its depth is its shorter side.
  faces = between(pointsOf(color, sensor, aux), height - 0.03, height + 0.03);
  if size(faces, 1) < 30, error('no %s is visible', name); end
  [middle, axes] = rectangleAround(faces);
  place = placeAt(middle, axes(2, :));
end
