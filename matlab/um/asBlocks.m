function blocks = asBlocks(things)
% Steps, or a container, as the blocks that they are for whoever must keep off them; see noBlocks.
  blocks = noBlocks();
  for it = things
    blocks(end + 1) = struct('color', it.color, 'size', it.size, 'position', it.position, 'yaw', it.yaw);
  end
end
