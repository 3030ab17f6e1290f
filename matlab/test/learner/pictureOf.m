function [picture, heights] = pictureOf(blocks)
% Renders blocks as the eye sees them, lower ones first: 480x640x3; and the height of what each pixel shows,
% 480x640 [units].
  persistent planes;  % by height, where the pixels meet the horizontal plane
  if isempty(planes), planes = containers.Map('KeyType', 'double', 'ValueType', 'any'); end
  [column, row] = meshgrid(1:640, 1:480);
  flat = repmat([0.6, 0.5, 0.4], 480 * 640, 1);
  heights = zeros(480, 640);
  for it = blocks
    % Rectangles below each other form the sides. The top is drawn last.
    for height = it.position(3) + it.size(3) * (-5:2:5) / 10
      if ~isKey(planes, height)
        [x, y] = ontoPlane(row(:), column(:), robotEye(), height);
        planes(height) = [x, y];
      end
      points = planes(height);
      x = points(:, 1) - it.position(1);
      y = points(:, 2) - it.position(2);
      along = abs(x * cos(it.yaw) + y * sin(it.yaw));
      across = abs(y * cos(it.yaw) - x * sin(it.yaw));
      hit = along <= it.size(1) / 2 & across <= it.size(2) / 2;
      if isRound(it), hit = hypot(along, across) <= it.size(1) / 2; end
      shade = 0.7;
      if height == it.position(3) + it.size(3) / 2, shade = 1; end
      flat(hit, :) = repmat(shade * it.color, sum(hit), 1);
      heights(hit) = height;
    end
  end
  picture = reshape(flat, 480, 640, 3);
end
