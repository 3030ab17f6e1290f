function path = planPathThrough(robot, arm, poses, others, q)
% Plans the paths of an arm to the first of some tool poses, along straight lines through the others, and
% to its parking pose: a 1xN cell; {} if there is none.
%   poses   1xN cell of 4x4 [units]
%   others  obstacles for the forearm, as blocks, where the tool is lower than the highest pose
%   q       2x7, joint angles of the arms [rad]
  height = max(cellfun(@(pose) pose(3, 4), poses));
  park = parkedAngles(arm);
  for start = [park; robot.poses.untucked(arm, :); robot.poses.neutral(arm, :)]'
    above = solvePoseSequence(robot, arm, poses, start');
    if isempty(above), continue; end
    path = {moveJoints(robot, arm, [q(arm, :); above])};
    for pose = poses(2:end)
      path{end + 1} = moveLine(robot, arm, path{end}, pose{1});
      if isempty(path{end}), break; end
    end
    if isempty(path{end}), continue; end
    low = find(cellfun(@(pose) pose(3, 4) < height, poses));
    if ~all(arrayfun(@(i) isForearmClear(robot, arm, path{i}.positions(end, :), others), low)), continue; end
    path{end + 1} = moveJoints(robot, arm, [path{end}.positions(end, :); park]);
    if all(cellfun(@(move) isPathValid(robot, move, arm), path)), return; end
  end
  path = {};
end
