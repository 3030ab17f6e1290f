function actions = carryWith(robot, arm, block, take, goal, put, height, others, q)
% The actions that carry a block with one arm, the fingers turned as told at either place; {} if that arm
% cannot.
%   height  of the tool on the way [units]
%   others  blocks that are not to be touched
  open = block.size(2) + 0.2;
  grip = [0, 0, block.size(3) / 2 - 0.2];  % where the tool holds it, from its centre
  from = toolPose(block.position + grip, take);
  to = toolPose(goal.position + grip + [0, 0, 0.01], put);
  over_from = from;
  over_from(3, 4) = height;
  over_to = to;
  over_to(3, 4) = height;
  park = parkedAngles(arm);
  actions = {};
  for start = [park; robot.poses.untucked(arm, :); robot.poses.neutral(arm, :)]'
    above = reachInTurn(robot, arm, {over_from, from, over_to, to}, start');
    if isempty(above), continue; end
    path = {moveJoints(robot, arm, [q(arm, :); above])};
    for pose = {from, over_from, over_to, to, over_to}
      path{end + 1} = moveLine(robot, arm, path{end}, pose{1});
      if isempty(path{end}), break; end
    end
    if isempty(path{end}), continue; end
    path{end + 1} = moveJoints(robot, arm, [path{end}.positions(end, :); park]);
    clears = @(i) armClears(robot, arm, path{i}.positions(end, :), others);
    if ~clears(2) || ~clears(5), continue; end
    if ~all(cellfun(@(move) isSafe(robot, move, arm), path)), continue; end

    follow = @(i) struct('kind', 'follow', 'arm', arm, 'path', path{i});
    actions = {struct('kind', 'grip', 'arm', arm, 'to', open), follow(1), follow(2), ...
               struct('kind', 'take', 'arm', arm, 'width', block.size(2)), follow(3), follow(4), ...
               follow(5), struct('kind', 'grip', 'arm', arm, 'to', open), follow(6), follow(7), ...
               struct('kind', 'look')};
    return
  end
end
