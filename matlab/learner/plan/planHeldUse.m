function actions = planHeldUse(hold, taken, load, tool, way, turn, avoided, ways)
% Plans a use with a tool in a hold (see toolHolds): a 1xN cell; {} if the arm cannot.
%   taken    paths on which it takes the tool: see planToTake
%   load     see loadOf
%   way      1x2 cell: the places where the tool's straight way to its work begins and ends
%   turn     of the tool until then [rad]
%   avoided  surroundings on the way there and back, and on that straight way, 1x2: see surroundingsOf
%   ways     ways there and back, in the order in which they are tried: see planThereAndBack
  c = constants().motion_planning;
  arm = hold.arm;
  width = tool.size(2);
  opening = min(width + c.opening_margin, arm.opening);
  [above, start] = hold.poses{1:2};
  put = {above, atHeight(start, start(3, 4) + c.place_height_margin), above};
  at = @(it) heldToolPose(arm, tool, hold.grasp.yaw, hold.grip, it, turn);
  work = cellfun(at, way, 'UniformOutput', false);
  [around, at_work] = deal(avoided(1), avoided(2));
  isWayClear = @(path) avoids(around, arm, path, load);
  isRestClear = @(paths) isWayClear(paths{7}) && avoids(at_work, arm, paths{5}) && avoids(at_work, arm, paths{6}) && ...
                         avoids(around, arm, paths{1}) && avoids(around, arm, paths{10});
  path = planThereAndBack(arm, taken, work([1, 2, 1]), put, ways, boxAround(load), isWayClear, isRestClear);
  actions = {};
  if isempty(path), return; end
  move = cellfun(@(it) struct('kind', 'follow', 'arm', arm, 'path', it), path, 'UniformOutput', false);
  move{3}.kind = 'lift';
  open = {struct('kind', 'open', 'arm', arm, 'to', opening)};
  closing = {struct('kind', 'grasp', 'arm', arm, 'width', width)};
  actions = [open, move(1:2), closing, move(3:5), closing, move(6:8), open, move(9:end), {struct('kind', 'observe')}];
end
