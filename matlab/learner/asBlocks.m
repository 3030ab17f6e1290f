function blocks = asBlocks(objects)
% Returns steps, or a container, as plain blocks (see noBlocks): obstacles for planning.
  blocks = noBlocks();
  for it = objects
    blocks(end + 1) = struct('color', it.color, 'size', it.size, 'position', it.position, 'yaw', it.yaw);
  end
end
