function pose = heldToolPose(arm, tool, across, grip, position, turn)
% Returns the pose of an arm's tool, 4x4, when it holds a tool (see toolHolds) that was turned [rad], at a position.
%   across  direction from finger to finger, before it was turned [rad]
  along = [rotated([grip, 0], tool.yaw + turn), tool.size(3) / 2 - gripDepth(arm, tool.size(3))];
  pose = toolPose(arm, position + along, across + turn, tool.size(2));
end
