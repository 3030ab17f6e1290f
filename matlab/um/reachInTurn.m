function first = reachInTurn(robot, arm, poses, q)
% The angles for the first of some poses, if an arm that begins near q gets from each to the next; else [].
  names = {'left', 'right'};
  first = [];
  for i = 1:numel(poses)
    q = smileInverse(robot, names{arm}, poses{i}, q, 'maxIterations', constants().carry.ik_iterations);
    if isempty(q) || ~keepsOffChest(robot, arm, q)
      first = [];
      return
    end
    if i == 1, first = q; end
  end
end
