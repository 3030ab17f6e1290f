function yes = isReachable(arm, place)
% Returns true if an arm can bring its tool to 2 and 0.3 units above the middle of the part by which a block is
% held, at a place.
  heights = constants().motion_planning.reach_heights;
  yes = false;
  for it = heldAnyhow(place)
    held = heldPart(it);
    for across = graspYaws(held, [])
      poses = arrayfun(@(height) {toolPose(arm, held.position + [0, 0, height], across, held.size(2))}, heights(:)');
      yes = ~isempty(solvePoses(arm, poses, arm.parked));
      if yes, return; end
    end
  end
end
