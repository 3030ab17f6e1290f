function rack = findRack(sensor, aux)
% Returns the place of the rack: it has two light panels in front of its slots.
  panels = between(pointsOf([213 218 224], sensor, aux), 0.3, 0.4);
  if size(panels, 1) < 500, error('no rack is visible'); end
  [middle, axes] = rectangleAround(panels);
  depthAxis = axes(2, :);
  walls = between(pointsOf([138 147 157], sensor, aux), 0.5, 0.6);
  if (mean(walls(:, 1:2), 1) - middle) * depthAxis' < 0, depthAxis = -depthAxis; end
  rack = placeAt(middle + 1.3 * depthAxis, depthAxis);
end
