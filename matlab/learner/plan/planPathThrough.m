function path = planPathThrough(arm, poses, others, q)
% Plans the paths of an arm to the first of some tool poses, along straight lines through the others, and
% to its parking pose: a 1xN cell; {} if there is none.
%   poses   1xN cell of 4x4 [units]
%   others  obstacles for the arm, as blocks, where the tool is lower than the highest pose
%   q       its joint angles, 1xn [rad]
  height = max(cellfun(@(pose) pose(3, 4), poses));
  for start = arm.starts'
    above = solvePoseSequence(arm, poses, start');
    if isempty(above), continue; end
    path = {moveJoints(arm, [q; above])};
    for pose = poses(2:end)
      path{end + 1} = moveLine(arm, path{end}, pose{1});
      if isempty(path{end}), break; end
    end
    if isempty(path{end}), continue; end
    low = find(cellfun(@(pose) pose(3, 4) < height, poses));
    if ~all(arrayfun(@(i) isArmClear(arm, path{i}.positions(end, :), others), low)), continue; end
    path{end + 1} = moveJoints(arm, [path{end}.positions(end, :); arm.parked]);
    % From and to where it waits, only this tells whether it passes over all.
    is_over = @() all(cellfun(@(move) isPathOver(arm, move, others), path([1, end])));
    if all(cellfun(@(move) isPathValid(arm, move), path)) && is_over(), return; end
  end
  path = {};
end
