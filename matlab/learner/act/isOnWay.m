function yes = isOnWay(block, way)
% Returns true if a block is so close to a way (see pushWays) that it comes to its goal when it is pushed there.
  c = constants();
  deviation = c.motion_planning.max_push_deviation;
  offset = block.position - way.last.position;
  along = offset(1:2) * way.away';
  across = offset([2, 1]) .* [1, -1] * way.away';
  yes = along > 0 && along < c.motion_planning.push_distance + deviation && max(abs([across, offset(3)])) < deviation && ...
        abs(yawDifference(block, way.last.yaw)) < c.blocks.yaw_tolerance_rad;
end
