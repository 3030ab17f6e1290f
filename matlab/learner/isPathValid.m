function yes = isPathValid(robot, path, arm)
% Returns true if an arm can follow a path while the other arm is parked.
  yes = avoidsTorso(robot, arm, path.positions) && ...
        isempty(smileFirstInvalid(robot, path, 'qBoth', [parkedAngles(1); parkedAngles(2)]));
end
