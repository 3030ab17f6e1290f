function yes = isSafe(robot, path, arm)
% Whether an arm can go along a path while the other one is parked.
  yes = keepsOffChest(robot, arm, path.positions) && ...
        isempty(smileFirstInvalid(robot, path, 'qBoth', [parkedAngles(1); parkedAngles(2)]));
end
