function found = wayToPush(arms, step, before)
% Returns the first way (see pushWays) to the place of a step to whose start the arm nearest to it can bring a block, and push it
% there; an empty struct array if there is none.
%   before  what stands there then, as blocks
  arm = nearestFirst(arms, step.position(1))(1);
  clearance = constants().motion_planning.clearance;
  for way = pushWays(step, step, before)
    if ~isReachable(arm, way.start), continue; end
    over = way.start.position(3) + way.start.size(3) / 2 + arm.reach + clearance;
    for hand = pushingHands(arm, way.start, way, before)
      found = way;
      if ~isempty(solvePoseSequence(arm, [{atHeight(hand.poses{1}, over)}, hand.poses], arm.parked)), return; end
    end
  end
  found = struct([]);
end
