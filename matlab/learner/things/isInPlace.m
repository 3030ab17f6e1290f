function yes = isInPlace(block, step)
% Returns true if a block is in the place of a step.
  c = constants().blocks;
  yes = isSameKind(block, step) && norm(block.position - step.position) < step.tolerance && ...
        abs(yawDifference(step, block.yaw)) < c.yaw_tolerance_rad;
end
