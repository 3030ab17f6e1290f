function path = planToTake(hold, q, held)
% Plans the paths of an arm to the first of the poses of a hold (see toolHolds), and along straight lines through the others: a
% 1xN cell; {} if there are none.
%   q     its joint angles, 1xn [rad]
%   held  box around what it takes: see isPathValid
  arm = hold.arm;
  path = moveLines(arm, {moveJoints(arm, [q; hold.above])}, hold.poses(2:end));
  if isempty(path) || ~arePathsValid(arm, path(1:2)) || ~arePathsValid(arm, path(3:end), held), path = {}; end
end
