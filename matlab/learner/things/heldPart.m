function part = heldPart(block)
% Returns the part by which a block is held: its knob where that is now, or the block.
  part = block;
  if isempty(block.knob), return; end
  away = [rotated(block.knob.position(1:2), block.yaw), block.knob.position(3)];
  part = newBlock(block.knob.color, block.knob.size, block.position + away, block.yaw + block.knob.yaw);
end
