function place = findBin(sensor, aux)
% Returns the place of the bin, whose rim is 0.6 high and longer than wide.
  rim = between(pointsOf([122 92 62], sensor, aux), 0.58, 0.62);
  if size(rim, 1) < 100, error('no bin is visible'); end
  [middle, axes] = rectangleAround(rim);
  place = placeAt(middle, axes(1, :));
end
