function path = planThereAndBack(arm, take, work, put, ways, q, held, isClear)
% Plans the paths of an arm to the first of some tool poses and along straight lines through the others, on the first possible
% way to its work and back, and to its parking pose: a 1xN cell; {} if there is none.
%   take, work, put  tool poses, 1xN cells of 4x4 [units]; it takes something at the second pose of take, and leaves it at the
%            second of put, which begins where take ended
%   ways     1xN, in the order in which they are tried: a straight line (is_line), or any way, which passes over both poses at a
%            height of the tool (height [units]); 0 for no such height
%   q        its joint angles, 1xn [rad]
%   held     box around what it takes: see isPathValid
%   isClear  function of these paths: whether nothing is in the way
  areValid = @(path, varargin) all(cellfun(@(move) isPathValid(arm, move, varargin{:}), path));
  for first = arm.starts'
    above = solvePoseSequence(arm, take, first');
    if isempty(above), continue; end
    taken = lines(arm, {moveJoints(arm, [q; above])}, take(2:end));
    if isempty(taken) || ~areValid(taken(1:2)) || ~areValid(taken(3:end), held), continue; end
    for way = ways
      path = thereAndBack(arm, taken, work, put, way);
      if isempty(path), continue; end
      path{end + 1} = moveJoints(arm, [path{end}.positions(end, :); arm.parked]);
      carried = path(numel(taken) + 1:end - 2);
      if areValid(carried, held) && areValid(path(end - 1:end)) && isClear(path), return; end
    end
  end
  path = {};
end

function path = thereAndBack(arm, taken, work, put, way)
% Returns some paths, and those that follow on a way to the first pose of some work, through the others, and back; {} if there
% are none.
  if way.is_line
    path = lines(arm, taken, [work, put]);
    return
  end
  path = {};
  via = taken{end}.positions(end, :);
  if way.height > 0
    over = {atHeight(smileForward(arm.robot, arm.name, via), way.height), atHeight(work{1}, way.height)};
    via = [via; solvePoses(arm, over, via, 0)];
    if rows(via) == 1, return; end
  end
  first = solvePoseSequence(arm, work, via(end, :));
  if isempty(first), return; end
  path = lines(arm, [taken, {moveJoints(arm, [via; first])}], work(2:end));
  if isempty(path), return; end
  back = moveJoints(arm, [path{end}.positions(end, :); flipud(via)]);
  path = lines(arm, [path, {back}], put(2:end));
end

function path = lines(arm, path, poses)
% Returns paths, and straight lines from the last of them through tool poses; {} if there are none.
  for pose = poses
    path{end + 1} = moveLine(arm, path{end}, pose{1});
    if isempty(path{end})
      path = {};
      return
    end
  end
end
