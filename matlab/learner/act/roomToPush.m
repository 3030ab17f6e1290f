function room = roomToPush(arms, way)
% Returns what a block at the start of a way (see pushWays) and the fingers that the nearest arm brings behind it take up, as one
% block.
  arm = nearestFirst(arms, way.last.position(1))(1);
  fingers = diff(smileFingerBounds(arm.robot, arm.name, 0));
  behind = fingers(1) + constants().motion_planning.push_margin;
  room = way.start;
  room.position(1:2) = room.position(1:2) + behind / 2 * way.away;
  room.size(1:2) = [way.along + behind, way.across];
  room.yaw = atan2(way.away(2), way.away(1));
end
