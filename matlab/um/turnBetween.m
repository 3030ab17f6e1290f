function turn = turnBetween(block, yaw)
% By how much a block has to turn to have a yaw, as little as possible [rad]: one with four equal sides
% looks the same every 90 degrees, any other every 180.
  period = pi;
  if hasEqualSides(block), period = pi / 2; end
  turn = yaw - block.yaw;
  turn = turn - period * round(turn / period);
end
