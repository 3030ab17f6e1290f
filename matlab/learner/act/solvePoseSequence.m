function first = solvePoseSequence(arm, poses, q)
% Solves inverse kinematics for a sequence of tool poses, each from the solution before, the first from q.
% Returns the first solution, 1xn [rad]; [] if some pose has none.
  first = [];
  for i = 1:numel(poses)
    q = armInverse(arm, poses{i}, q, 'maxIterations', constants().motion_planning.ik_iterations);
    if isempty(q) || ~avoidsTorso(arm, q)
      first = [];
      return
    end
    if i == 1, first = q; end
  end
end
