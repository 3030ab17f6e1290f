function grasp = tiltedGrasp(arm, block, held, sign, across, height, margin)
% Returns a way to hold a block for a turn.
%   held    the side by which it is held, as in turnedSize
%   sign    over which of two edges the tool comes, 1 or -1: toward which end along u
%   across  the direction from finger to finger, 1 or -1
%   height  at which the tool turns it [units]
%   grasp.arm, grasp.margin  as given
%   grasp.inBlock    pose of the tool in the frame of the block, 4x4. The axes of that frame are u, which will be
%                    vertical, the axis on which the fingers hold it, and z; its origin is the middle of the block.
%   grasp.sides      of the block along these axes, 1x3 [units]
%   grasp.attempt    see newGrasp
%   grasp.start      pose of the tool at the block, 4x4
%   grasp.overStart  and over it
%   grasp.q          joint angles over and at the block, 2xn, once they are found
  sides = block.size([3 - held, held, 3]);
  middle = smileGripperMiddle(arm.robot, arm.name, sides(2));
  axis = -[sign, 0, 1] / sqrt(2);
  y = [0, across, 0];
  % The edge over which the tool comes: its place from the middle.
  away = max(sides / 2 - constants().motion_planning.tilted_grip, lowestTiltedTool(arm) - sides / 2);
  in_block = [[cross(y, axis)', y', axis', [sign * away(1); -across * middle; away(3)]]; 0, 0, 0, 1];
  u = block.yaw;
  if held == 1, u = u + pi / 2; end
  start = poseAt(block.position, u) * in_block;
  grasp = struct('arm', arm, 'sides', sides, 'sign', sign, 'margin', margin, 'inBlock', in_block, ...
                 'attempt', newGrasp(block.position, arm, u + across * pi / 2), 'start', start, ...
                 'overStart', atHeight(start, heightOver(arm, block, height)), 'q', []);
end

function pose = poseAt(position, yaw)
% Returns the pose of an upright object, 4x4.
  c = cos(yaw);
  s = sin(yaw);
  pose = [c, -s, 0, position(1); s, c, 0, position(2); 0, 0, 1, position(3); 0, 0, 0, 1];
end
