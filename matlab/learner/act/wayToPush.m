function found = wayToPush(arms, step, before)
% Returns the first way (see pushWays) to the place of a step on which the nearest arm can push a block: it reaches the start of the
% way and all poses of the push. An empty struct array if there is none.
%   before  what stands there then, as blocks
  arm = nearestFirst(arms, step.position(1))(1);
  clearance = constants().motion_planning.clearance;
  for way = pushWays(step, step, before)
    if ~isReachable(arm, way.start), continue; end
    over = way.start.position(3) + way.start.size(3) / 2 + arm.reach + clearance;
    for hand = pushingHands(arm, way.start, way, before)
      found = way;
      if ~isempty(solvePoses(arm, [{atHeight(hand.poses{1}, over)}, hand.poses], arm.parked)), return; end
    end
  end
  found = struct([]);
end
