function yes = isPathValid(arm, path, held)
% Returns true if an arm can follow a path while the others are parked.
%   held  box around what it holds, in the frame of its tool: lower and upper corner, 2x3 [units]; optional
  options = {'qBoth', arm.allParked};
  if nargin > 2, options = [options, {'held', held}]; end
  yes = avoidsTorso(arm, path.positions) && isempty(smileFirstInvalid(arm.robot, path, options{:}));
end
