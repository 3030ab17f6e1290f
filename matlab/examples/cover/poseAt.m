function pose = poseAt(middle, height, across)
% Returns the pose of a tool that points down, over the middle (1x2) of a place, its fingers along `across` (1x3).
  pose = eye(4);
  pose(1:3, 1:3) = [cross(across, [0 0 -1])' across' [0; 0; -1]];
  pose(1:3, 4) = [middle(:); height];
end
