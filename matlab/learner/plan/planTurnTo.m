function actions = planTurnTo(grasp, block, held, place, others, sensor)
% Plans the actions that turn a block with a grasp (see tiltedGrasp) and put it at a place: a 1xN cell; {} if there are none.
  c = constants();
  arm = grasp.arm;
  width = block.size(held);
  opening = min(width + c.motion_planning.opening_margin, arm.opening);
  q = sensor.arms(arm.index).joints(:)';
  for ends = endPoses(grasp, place, turnHeight(block, others))
    actions = {};
    found = solvePoses(arm, ends', grasp.q(1, :), grasp.margin);
    if isempty(found) || ~isHandClear(arm, found, others, place), continue; end
    path = {moveJoints(arm, [q; grasp.q(1, :)])};
    for pose = {grasp.start, grasp.overStart, [], ends{2}, ends{1}}
      before = path{end}.positions(end, :);
      if isempty(pose{1})  % the turn
        path{end + 1} = moveJoints(arm, [before; found(1, :)]);
      else
        path{end + 1} = moveLine(arm, path{end}, pose{1});
      end
      if isempty(path{end}), break; end
    end
    if isempty(path{end}), continue; end
    path{end + 1} = moveJoints(arm, [path{end}.positions(end, :); arm.parked]);
    isValid = @(it) isempty(smileFirstInvalid(arm.robot, it, 'qBoth', arm.allParked, 'table', c.arms.table'));
    if ~passesOver(grasp, path{4}, others) || ~areFingersClear(arm, path{1}, [others, block]) || ...
       ~areFingersClear(arm, path{end}, [others, place]) || ~all(cellfun(isValid, path))
      continue
    end
    follow = cellfun(@(it) struct('kind', 'follow', 'arm', arm, 'path', it), path, 'UniformOutput', false);
    follow{3}.kind = 'lift';
    open = {struct('kind', 'open', 'arm', arm, 'to', opening)};
    take = {struct('kind', 'grasp', 'arm', arm, 'width', width, 'grasp', grasp.attempt)};
    actions = [open, follow(1:2), take, follow(3:5), open, follow(6:end), {struct('kind', 'observe')}];
    return
  end
end

function yes = passesOver(grasp, path, others)
% Returns true if a block that is held with a grasp stays above others on a path.
  [a, b, c] = ndgrid([1, -1], [1, -1], [1, -1]);
  corners = [a(:), b(:), c(:)] .* grasp.sides / 2;
  highest = max([0; blockTops(others)]);
  yes = true;
  for q = samplesOf(path)'
    pose = smileForward(grasp.arm.robot, grasp.arm.name, q') / grasp.inBlock;
    yes = yes && min(corners * pose(3, 1:3)') + pose(3, 4) > highest;
  end
end
