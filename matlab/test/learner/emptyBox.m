function blocks = emptyBox(color, x, y, yaw)
% Returns blocks that look like an open box: its rim, a dark side inside, and its floor.
  blocks = [block(color, [5, 2.6, 0.9], x, y, 0, yaw), block(0.7 * color, [4.6, 2.2, 0], x, y, 0.9, yaw), ...
            block(color, [4.2, 1.8, 0], x, y, 0.9, yaw)];
end
