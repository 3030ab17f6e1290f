function yes = isWithinReach(robot, arm, place)
% Whether an arm gets its tool to 2 units above a block's place, and down to it.
  heights = constants().carry.reach_heights;
  above = place.position + [0, 0, heights(1)];
  at = place.position + [0, 0, heights(2)];
  yes = false;
  for across = fingerTurns(place, [])
    poses = {toolPose(above, across), toolPose(at, across)};
    yes = yes || ~isempty(reachInTurn(robot, arm, poses, parkedAngles(arm)));
  end
end
