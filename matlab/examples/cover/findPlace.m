function place = findPlace(name, color, height, sensor, aux)
% Returns the place of what has upper faces of a color (0 to 255) at a height: its middle, 1x2, and the directions
% x of its longer and y of its shorter side, 1x3.
  difference = max(abs(255 * sensor.rgbVision - reshape(color, 1, 1, 3)), [], 3);
  [row, column] = find(difference <= 12 & sensor.depthVision > 0);
  % From pixels to points: along the ray of each pixel, as far as its depth.
  depth = sensor.depthVision(sub2ind(size(sensor.depthVision), row, column));
  ray = aux.cameraIntrinsics \ [column' - 0.5; row' - 0.5; ones(1, numel(row))];
  points = sensor.cameraPose * [ray .* depth'; ones(1, numel(row))];
  points = points(1:2, abs(points(3, :) - height) < 0.03);
  if columns(points) < 30, error('no %s is visible', name); end

  % The smallest rectangle around the points.
  least = Inf;
  for angle = (0:0.5:89.5) * pi / 180
    axes = [cos(angle) sin(angle); -sin(angle) cos(angle)];
    along = axes * points;
    low = min(along, [], 2);
    high = max(along, [], 2);
    if prod(high - low) < least
      least = prod(high - low);
      place.middle = (axes' * (low + high) / 2)';
      [~, order] = sort(high - low, 'descend');
      place.y = [axes(order(2), :) 0];
    end
  end
  place.x = [place.y(2) -place.y(1) 0];
end
