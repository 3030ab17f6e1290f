function spare = findSpare(sensor, aux)
% Returns the place of a good drive that stands on the table, where labels are 1.71 high.
  label = between(pointsOf([32 160 64], sensor, aux), 1.6, 1.8);
  plate = between(pointsOf([200 204 210], sensor, aux), 1.6, 1.8);
  if size(label, 1) < 50 || size(plate, 1) < 50, error('no spare drive is visible'); end
  % The label is at the near end of the drive, and the plate continues behind it.
  back = mean(plate(:, 1:2), 1) - mean(label(:, 1:2), 1);
  [middle, axes] = rectangleAround([label; plate]);
  [~, which] = max(abs(axes * back'));
  depthAxis = axes(which, :);
  if depthAxis * back' < 0, depthAxis = -depthAxis; end
  % Label and plate reach from 1.0 in front of the middle to 0.7 behind it.
  spare = placeAt(middle + 0.15 * depthAxis, depthAxis);
end
