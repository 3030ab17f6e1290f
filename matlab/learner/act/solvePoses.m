function found = solvePoses(arm, poses, q, margin)
% Returns the joint angles of a sequence of tool poses, 1xN cell, each searched from the one before, with a margin from their
% limits: Nxn [rad]; [] if one has none.
  found = [];
  for k = 1:numel(poses)
    q = armInverse(arm, poses{k}, q, 'maxIterations', constants().motion_planning.ik_iterations);
    if isempty(q) || ~avoidsTorso(arm, q) || min([q - arm.lower, arm.upper - q]) < margin
      found = [];
      return
    end
    found(k, :) = q;
  end
end
