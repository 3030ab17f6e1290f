function poses = endPoses(grasp, place, height)
% Returns the poses of the tool over and at a place of a block that was turned with a grasp (see tiltedGrasp), for each
% of its yaws that look alike: a 2xN cell of 4x4.
%   height  of the tool over it, at least [units]
  % Which of its sides is now along u: the axis of the fingers, or the former height.
  along = place.yaw;
  if grasp.sides(2) < grasp.sides(3), along = along + pi / 2; end
  poses = {};
  for yaw = along + [0, pi]
    u = [0, 0, grasp.sign];
    y = [cos(yaw), sin(yaw), 0];
    at = place.position + [0, 0, constants().motion_planning.place_height_margin];
    pose = [[u', y', cross(u, y)', at']; 0, 0, 0, 1] * grasp.inBlock;
    poses(:, end + 1) = {atHeight(pose, heightOver(grasp.arm, place, height)); pose};
  end
end
