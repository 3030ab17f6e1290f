function posture = toolPosture(point, yaw, shoulder, arm)
% The posture (see postureOf) that brings an arm's tool to a point, with the fingers along the sides
% of a square turned by yaw. shoulder is where the arm's mount is [units].
  shape = armShape(arm);
  gap = point - shoulder;
  direction = atan2(gap(2), gap(1));
  % A square can be taken in four ways. This is the one with the wrist turned least.
  twist = shape.twist + quarterTurn(yaw - direction - shape.twist);
  posture = [direction, norm(gap(1:2)), gap(3), twist];
end
