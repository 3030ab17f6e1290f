function actions = carryWith(robot, arm, block, take, goal, put, height, others, q)
% The actions that carry a block with one arm, the fingers turned as told at either place; {} if that arm
% cannot.
%   height  of the tool on the way [units]
%   others  blocks that are not to be touched
  c = constants().carry;
  open = block.size(2) + c.opening_margin;
  grip = [0, 0, block.size(3) / 2 - c.grip_below_top];  % where the tool holds it, from its centre
  from = toolPose(block.position + grip, take);
  to = toolPose(goal.position + grip + [0, 0, c.put_above], put);
  over_from = from;
  over_from(3, 4) = height;
  over_to = to;
  over_to(3, 4) = height;
  if ~isDrawn(goal)
    path = pathThrough(robot, arm, {over_from, from, over_from, over_to, to, over_to}, others, q);
  else  % what is drawn is not lifted
    path = pathThrough(robot, arm, {over_from, from, to, over_to}, others, q);
  end
  actions = {};
  if isempty(path), return; end

  follow = cellfun(@(it) struct('kind', 'follow', 'arm', arm, 'path', it), path, 'UniformOutput', false);
  grip = struct('kind', 'grip', 'arm', arm, 'to', open);
  take = struct('kind', 'take', 'arm', arm, 'width', block.size(2));
  actions = [{grip}, follow(1:2), {take}, follow(3:end - 2), {grip}, follow(end - 1:end), ...
             {struct('kind', 'look')}];
end
