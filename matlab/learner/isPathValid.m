function yes = isPathValid(arm, path)
% Returns true if an arm can follow a path while the others are parked.
  yes = avoidsTorso(arm, path.positions) && ...
        isempty(smileFirstInvalid(arm.robot, path, 'qBoth', arm.allParked));
end
