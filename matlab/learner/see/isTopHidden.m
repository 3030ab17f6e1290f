function yes = isTopHidden(block, others, eye)
% Returns true if others, blocks or steps, hide a part of a block's top from the eye: a line of sight from
% its middle or near one of its corners passes through one of them.
  yes = false;
  if isempty(others), return; end
  c = constants().perception;
  top = block.position(3) + block.size(3) / 2;
  places = vertcat(others.position);
  sizes = vertcat(others.size);
  tops = places(:, 3) + sizes(:, 3) / 2;
  higher = tops > top + c.on_table;
  if ~any(higher), return; end
  covered = footprint(others(higher), 0);
  bottoms = max(places(higher, 3) - sizes(higher, 3) / 2, top);
  z = bottoms + linspace(0, 1, c.sight_heights) .* (tops(higher) - bottoms);
  along = (z(:) - top) / (eye.pose(3, 4) - top);
  covered = repmat(covered, c.sight_heights, 1);
  % A row for each of the others at each height, a column for each point.
  points = topPoints(block)';
  x = points(1, :) + along .* (eye.pose(1, 4) - points(1, :)) - covered(:, 1);
  y = points(2, :) + along .* (eye.pose(2, 4) - points(2, :)) - covered(:, 2);
  yaw_cos = cos(covered(:, 5));
  yaw_sin = sin(covered(:, 5));
  is_inside = 2 * abs(x .* yaw_cos + y .* yaw_sin) < covered(:, 3) & 2 * abs(y .* yaw_cos - x .* yaw_sin) < covered(:, 4);
  yes = any(is_inside(:));
end
