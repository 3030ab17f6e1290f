function pose = poseAt(point, across)
% Returns the pose of a tool at a point (1x3), its approach straight down and its fingers along `across` (1x3).
  pose = eye(4);
  pose(1:3, 1:3) = [cross(across, [0 0 -1])', across', [0; 0; -1]];
  pose(1:3, 4) = point(:);
end
