function yes = isReachable(robot, arm, place)
% Returns true if an arm can bring its tool to a block's place, and 2 units above it.
  heights = constants().motion_planning.reach_heights;
  above = place.position + [0, 0, heights(1)];
  at = place.position + [0, 0, heights(2)];
  yes = false;
  for across = graspYaws(place, [])
    poses = {toolPose(above, across), toolPose(at, across)};
    yes = yes || ~isempty(solvePoseSequence(robot, arm, poses, parkedAngles(arm)));
  end
end
