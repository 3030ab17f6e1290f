function rotation = yawDifference(block, yaw)
% Returns the smallest rotation of a block to a yaw [rad]: a block with four equal sides looks the same
% every 90 degrees, any other every 180, round ones always, and things of several colors never.
  period = pi;
  if hasEqualSides(block), period = pi / 2; end
  if ~isempty(block.parts), period = 2 * pi; end
  rotation = 0;
  if isRound(block), return; end
  rotation = yaw - block.yaw;
  rotation = rotation - period * round(rotation / period);
end
