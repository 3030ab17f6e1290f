function links = linksOf(arm, q)
% Returns points along an arm at joint angles, one or more rows [rad], from its tool to its first joint, Nx3 [units].
  links = pointsBetween(armPoints(arm, q), constants().motion_planning.points_per_link);
end
