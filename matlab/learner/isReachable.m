function yes = isReachable(arm, place)
% Returns true if an arm can bring its tool to a block's place, and 2 units above it.
  place = heldPart(place);
  heights = constants().motion_planning.reach_heights;
  above = place.position + [0, 0, heights(1)];
  at = place.position + [0, 0, heights(2)];
  yes = false;
  for across = graspYaws(place, [])
    poses = {toolPose(arm, above, across, place.size(2)), toolPose(arm, at, across, place.size(2))};
    yes = yes || ~isempty(solvePoseSequence(arm, poses, arm.parked));
  end
end
