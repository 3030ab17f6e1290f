function points = topPoints(block)
% Returns the middle of a block's top and points near its corners, 5x3 [units].
  c = constants().perception;
  along = c.top_fraction * block.size(1) * [cos(block.yaw), sin(block.yaw), 0];
  across = c.top_fraction * block.size(2) * [-sin(block.yaw), cos(block.yaw), 0];
  middle = block.position + [0, 0, block.size(3) / 2];
  points = middle + [0, 1, 1, -1, -1]' * along + [0, 1, -1, -1, 1]' * across;
end
