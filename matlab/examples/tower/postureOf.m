function posture = postureOf(q, arm)
% What an arm with these joint angles does with its tool, as four numbers:
%   [direction, distance, height, twist] of the tool, the first three from the arm's mount; the
%   direction counts from the table's x axis, the twist of the tool's x axis from the direction
%   [rad, units, units, rad].
  shape = armShape(arm);
  [position, rotation] = forwardKinematics(q, arm);
  direction = atan2(position(2), position(1));
  twist = atan2(rotation(2, 1), rotation(1, 1)) - direction;
  twist = twist + 2 * pi * round((shape.twist - twist) / (2 * pi));
  posture = [direction, norm(position(1:2)), position(3), twist];
end
