function pose = atHeight(pose, height)
% Returns a pose, 4x4, at another height [units].
  pose(3, 4) = height;
end
