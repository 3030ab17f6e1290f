function yes = isPushable(arms, step, before)
% Returns true if the arm nearest to the place of a step can bring a block to the start of a way to it (see pushWays), and push
% it there.
%   before  what stands there then, as blocks
  arm = nearestFirst(arms, step.position(1))(1);
  clearance = constants().motion_planning.clearance;
  yes = false;
  for way = pushWays(step, step, before)
    if ~isReachable(arm, way.start), continue; end
    over = way.start.position(3) + way.start.size(3) / 2 + arm.reach + clearance;
    for hand = pushingHands(arm, way.start, way, before)
      yes = ~isempty(solvePoseSequence(arm, [{atHeight(hand.poses{1}, over)}, hand.poses], arm.parked));
      if yes, return; end
    end
  end
end
