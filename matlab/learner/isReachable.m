function yes = isReachable(arm, place)
% Returns true if an arm can bring its tool to a block's place, and 2 units above it.
  heights = constants().motion_planning.reach_heights;
  yes = false;
  for it = heldAnyhow(place)
    held = heldPart(it);
    for across = graspYaws(held, [])
      poses = arrayfun(@(height) {toolPose(arm, held.position + [0, 0, height], across, held.size(2))}, heights(:)');
      yes = yes || ~isempty(solvePoseSequence(arm, poses, arm.parked));
    end
  end
end
