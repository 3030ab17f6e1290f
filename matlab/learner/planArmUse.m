function actions = planArmUse(arm, tool, looks, across, way, turn, avoided, ways, q)
% Plans a use of a tool with one arm and a yaw of the gripper: a 1xN cell; {} if that arm cannot.
%   looks   visible points of the tool, Nx3
%   across  direction from finger to finger [rad]
%   way     1x2 cell: the places where the tool's straight way to its work begins and ends
%   turn    of the tool until then [rad]
%   avoided  surroundings on the way there and back, and on that straight way, 1x2: see surroundingsOf
%   ways    ways there and back, in the order in which they are tried: see planThereAndBack
%   q       the joint angles of the arm, 1xn [rad]
  c = constants();
  width = tool.size(2);
  opening = min(width + c.motion_planning.opening_margin, arm.opening);
  height = tool.size(3) / 2 - gripDepth(arm, tool.size(3));
  actions = {};
  for grip = c.uses.grips'
    % It is held at some distance from its middle, along it.
    start = toolPose(arm, tool.position + [rotated([grip, 0], tool.yaw), height], across, width);
    put = atHeight(start, start(3, 4) + c.motion_planning.place_height_margin);
    there = [rotated([grip, 0], tool.yaw + turn), height];
    work = cellfun(@(it) toolPose(arm, it + there, across + turn, width), way([1, 2, 1]), 'UniformOutput', false);
    load = loadOf(looks, tool.position(3), start);
    isClear = @(path) isUseClear(arm, path, load, avoided);
    for lift = c.uses.lifts'
      over = atHeight(start, start(3, 4) + lift);
      path = planThereAndBack(arm, {over, start, over}, work, {over, put, over}, ways, q, boxAround(load), isClear);
      if isempty(path), continue; end
      move = cellfun(@(it) struct('kind', 'follow', 'arm', arm, 'path', it), path, 'UniformOutput', false);
      open = {struct('kind', 'open', 'arm', arm, 'to', opening)};
      hold = {struct('kind', 'grasp', 'arm', arm, 'width', width)};
      actions = [open, move(1:2), hold, move(3:5), hold, move(6:8), open, move(9:end), {struct('kind', 'observe')}];
      return
    end
  end
end

function yes = isUseClear(arm, path, load, avoided)
% Returns true if nothing is in the way of the empty arm, the arm with its load, and the arm at work, in the paths of a use.
  there = avoided(1);
  at_work = avoided(2);
  yes = all(cellfun(@(it) avoids(there, arm, it, load), path([4, 7]))) && ...
        all(cellfun(@(it) avoids(at_work, arm, it), path(5:6))) && ...
        all(cellfun(@(it) avoids(there, arm, it), path([1, 10])));
end

function box = boxAround(load)
% Returns the lower and the upper corner of a box around points, which are one for each cell, 2x3 [units].
  half = constants().skyline.cell / 2;
  box = [min(load, [], 1) - half; max(load, [], 1) + half];
end
