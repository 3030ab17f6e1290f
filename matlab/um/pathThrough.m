function path = pathThrough(robot, arm, poses, others, q)
% The paths of an arm to the first of some poses of its tool, straight on from each to the next, and to
% where it parks, a 1xN cell; {} if it cannot.
%   others  blocks that its forearm keeps off where the tool is lower than on the way
%   q       2x7, where the arms are [rad]
  height = max(cellfun(@(pose) pose(3, 4), poses));
  park = parkedAngles(arm);
  for start = [park; robot.poses.untucked(arm, :); robot.poses.neutral(arm, :)]'
    above = reachInTurn(robot, arm, poses, start');
    if isempty(above), continue; end
    path = {moveJoints(robot, arm, [q(arm, :); above])};
    for pose = poses(2:end)
      path{end + 1} = moveLine(robot, arm, path{end}, pose{1});
      if isempty(path{end}), break; end
    end
    if isempty(path{end}), continue; end
    low = find(cellfun(@(pose) pose(3, 4) < height, poses));
    if ~all(arrayfun(@(i) armClears(robot, arm, path{i}.positions(end, :), others), low)), continue; end
    path{end + 1} = moveJoints(robot, arm, [path{end}.positions(end, :); park]);
    if all(cellfun(@(move) isSafe(robot, move, arm), path)), return; end
  end
  path = {};
end
