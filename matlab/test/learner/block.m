function it = block(color, size, x, y, bottom, yaw)
  it = newBlock(color, size, [x, y, bottom + size(3) / 2], yaw);
end
