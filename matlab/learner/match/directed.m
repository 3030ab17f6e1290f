function yaw = directed(block, yaw)
% Returns the yaw of a block, of the two with which it looks the same that which is nearer to another [rad].
  yaw = block.yaw + pi * round((yaw - block.yaw) / pi);
end
