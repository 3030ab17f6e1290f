function posture = holdingPosture(place, yaw, shoulder, arm)
% Where the tool holds a block whose top is at `place`. The fingers are half as long again as the block
% and shall end just above what it stands on.
  posture = toolPosture(place - [0, 0, 0.2], yaw, shoulder, arm);
end
