function path = planThereAndBack(arm, taken, work, put, ways, held, isWayClear, isRestClear)
% Plans the paths of an arm that took something along straight lines through the tool poses of its work, on the first possible
% way there and back, and to its parking pose: a 1xN cell, which begins with the paths on which it took that; {} if there is
% none.
%   taken    paths, see planToTake
%   work, put  tool poses, 1xN cells of 4x4 [units]; it leaves what it holds at the second of put, which begins where the paths
%            ended
%   ways     1xN, in the order in which they are tried: a straight line (is_line), or any way, which passes over both poses at a
%            height of the tool (height [units]); 0 for no such height
%   held     box around what it holds: see isPathValid
%   isWayClear  function of the path there: whether nothing is in the way
%   isRestClear  function of all paths, of which that one is clear
  % Most ways are excluded by where the work begins or on the way there: this is looked at before the rest is planned.
  canBegin = @(q) isPathValid(arm, moveJoints(arm, q), held);
  for way = ways
    [there, via] = thereOn(arm, taken, work, way, canBegin);
    if isempty(there) || ~isPathValid(arm, there{end}, held) || ~isWayClear(there{end}), continue; end
    path = backAfter(arm, moveLines(arm, there, work(2:end)), put, via);
    if isempty(path), continue; end
    path{end + 1} = moveJoints(arm, [path{end}.positions(end, :); arm.parked]);
    carried = path(numel(there) + 1:end - 2);
    if arePathsValid(arm, carried, held) && arePathsValid(arm, path(end - 1:end)) && isRestClear(path), return; end
  end
  path = {};
end

function [path, via] = thereOn(arm, taken, work, way, canBegin)
% Returns some paths and the one that follows on a way to the first pose of some work, {} if there is none; and the joint angles
% between which it leads, [] for a straight line.
%   canBegin  function of joint angles: whether the work can begin there
  via = [];
  if way.is_line
    path = moveLines(arm, taken, work(1));
    if ~isempty(path) && ~canBegin(path{end}.positions(end, :)), path = {}; end
    return
  end
  path = {};
  via = taken{end}.positions(end, :);
  if way.height > 0
    over = {atHeight(smileForward(arm.robot, arm.name, via), way.height), atHeight(work{1}, way.height)};
    via = [via; solvePoses(arm, over, via)];
    if rows(via) == 1, return; end
  end
  first = solvePoses(arm, work(1), via(end, :));
  if isempty(first) || ~canBegin(first) || (numel(work) > 1 && isempty(solvePoses(arm, work(2:end), first))), return; end
  path = [taken, {moveJoints(arm, [via; first])}];
end

function path = backAfter(arm, path, put, via)
% Returns some paths, and those that follow back between joint angles via, see thereOn, and through the poses where the arm puts
% what it holds; {} if there are none.
  if ~isempty(path) && ~isempty(via)
    path{end + 1} = moveJoints(arm, [path{end}.positions(end, :); flipud(via)]);
    put = put(2:end);
  end
  path = moveLines(arm, path, put);
end
