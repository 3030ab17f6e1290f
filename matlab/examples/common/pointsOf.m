function points = pointsOf(color, sensor, aux, isShaded)
% Returns the visible points (Nx3) of a color, [red green blue] from 0 to 255. Upper faces and lamps have the color of
% the object; other faces are darker, and count if isShaded.
  picture = reshape(sensor.rgbVision, [], 3) * 255;
  brightness = ones(size(picture, 1), 1);
  if nargin > 3 && isShaded
    brightness = min(max(picture * color' / (color * color'), 0.3), 1);
  end
  difference = max(abs(picture - brightness * color), [], 2);
  found = find(difference <= 12 * brightness & sensor.depthVision(:) > 0);
  [row, column] = ind2sub(size(sensor.depthVision), found);
  % From pixels to points: along the ray of each pixel, as far as its depth.
  ray = aux.cameraIntrinsics \ [column' - 0.5; row' - 0.5; ones(1, numel(row))];
  depth = sensor.depthVision(found)';
  points = (sensor.cameraPose(1:3, 1:3) * (ray .* depth) + sensor.cameraPose(1:3, 4))';
end
