function found = solvePoses(arm, poses, q, margin)
% Returns the joint angles of a sequence of tool poses, 1xN cell, each searched from the one before, the first from q, with a
% margin from their limits [rad], 0 if omitted: Nxn [rad]; [] if one has none.
  found = armInverse(arm, cat(3, poses{:}), q, 'maxIterations', constants().motion_planning.ik_iterations);
  if isempty(found), return; end
  if nargin < 4, margin = 0; end
  room = min(min(found - arm.lower, arm.upper - found)(:));
  if room < margin || ~avoidsTorso(arm, found), found = []; end
end
