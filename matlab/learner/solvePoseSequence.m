function first = solvePoseSequence(robot, arm, poses, q)
% Solves inverse kinematics for a sequence of tool poses, each from the solution before, the first from q.
% Returns the first solution, 1x7 [rad]; [] if some pose has none.
  names = {'left', 'right'};
  first = [];
  for i = 1:numel(poses)
    q = smileInverse(robot, names{arm}, poses{i}, q, ...
                     'maxIterations', constants().motion_planning.ik_iterations);
    if isempty(q) || ~avoidsTorso(robot, arm, q)
      first = [];
      return
    end
    if i == 1, first = q; end
  end
end
