function turn = turnBetween(block, yaw)
% By how much a block would have to turn to have a yaw, at most [rad]: one with four equal sides looks
% the same every 90 degrees, any other every 180.
  period = pi;
  if hasEqualSides(block), period = pi / 2; end
  turn = yaw - block.yaw;
  turn = abs(turn - period * round(turn / period));
end
