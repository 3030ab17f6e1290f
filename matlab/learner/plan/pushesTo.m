function [actions, starts] = pushesTo(arms, block, goal, others, sensor, failures)
% Plans the pushes that bring a block to a goal, a step or a block, from where a way there begins (see pushWays).
%   arms, others, sensor, failures  as in planPickAndPlace
%   actions  of the push for which the block is in place, a 1xN cell; {} if there is none
%   starts   the block at the starts of the others, a 1xN struct array
  actions = {};
  starts = noBlocks();
  for way = pushWays(block, goal, others)
    is_there = isOnWay(block, way);
    start = way.start;
    if is_there, start = block; end
    actions = planPush(arms, start, way, others, sensor, failures);
    if ~isempty(actions) && is_there
      starts = noBlocks();
      return
    end
    if ~isempty(actions), starts(end + 1) = start; end
    actions = {};
  end
end

function actions = planPush(arms, block, way, others, sensor, failures)
% Plans to push a block that is on a way to its goal: a 1xN cell; {} if no arm can do it.
  height = max(blockTops([others, block]));
  for arm = nearestFirst(arms, way.last.position(1))
    for hand = pushingHands(arm, block, way, others)
      attempt = newGrasp(block.position, arm, hand.across);
      if hasFailed(attempt, failures), continue; end
      over = height + arm.reach + constants().motion_planning.clearance;
      poses = [{atHeight(hand.poses{1}, over)}, hand.poses, {atHeight(hand.poses{3}, over)}];
      path = planPathThrough(arm, poses, others, sensor.arms(arm.index).joints(:)', way.last, block);
      if isempty(path), continue; end
      moves = cellfun(@(it) struct('kind', 'follow', 'arm', arm, 'path', it), path, 'UniformOutput', false);
      moves{3} = struct('kind', 'push', 'arm', arm, 'path', path{3}, 'grasp', attempt);
      actions = [{struct('kind', 'open', 'arm', arm, 'to', hand.opening)}, moves, {struct('kind', 'observe')}];
      return
    end
  end
  actions = {};
end
