function rotation = yawDifference(block, yaw)
% Returns the smallest rotation of a block to a yaw [rad]: a block with four equal sides looks the same
% every 90 degrees, any other every 180, round ones always, things of several colors never,
% and one with an outline as that does.
  period = pi;
  if hasEqualSides(block), period = pi / 2; end
  if ~isempty(block.parts), period = 2 * pi; end
  is_symmetric = false;
  if ~isempty(block.outline)
    is_symmetric = block.outline.fold == 0;
    period = 2 * pi / block.outline.fold;
  end
  rotation = 0;
  if isRound(block) || is_symmetric, return; end
  rotation = yaw - block.yaw;
  rotation = rotation - period * round(rotation / period);
end
