function [actions, reason] = planPickAndPlace(arms, block, goal, others, sensor, failures, way)
% Plans the actions that bring a block to a goal, a step or a block, and end with an observation; {} and a
% reason if no arm can do it.
%   arms    those that may do it, see armsOf
%   others  obstacles, as blocks
%   failures  grasps that failed and are not to be repeated, see newGrasp; [] for none
%   way     in which it is preferably held and carried, see wayOf; optional
  if nargin < 7, way = wayOf(choicesOf(struct()), 0); end
  reason = '';
  for it = heldAnyhow(block)
    [actions, why] = planHeld(arms, it, goal, others, sensor, failures, way);
    if ~isempty(actions), return; end
    if isempty(reason), reason = why; end
  end
end

function [actions, reason] = planHeld(arms, block, goal, others, sensor, failures, way)
% Plans how a block that is held in one way is brought to a goal, see planPickAndPlace.
  actions = {};
  goal.knob = block.knob;
  held = asBlocks(heldPart(block));
  target = asBlocks(heldPart(goal));
  grasp_yaws = graspYaws(block, others);
  place_yaws = graspYaws(goal, others);
  reason = 'there is no room for the fingers';
  if isempty(grasp_yaws) || isempty(place_yaws), return; end

  [able, reason] = ableArms(arms, block, held.size(2), failures, 'no arm reaches both its place and its goal');
  if isempty(able), return; end
  away = [];
  if ~isDragged(goal), away = besideTouching(target, others); end

  % What cannot be lifted as high as necessary to pass over all others is lifted less on a low way.
  trials = false;
  if ~isDragged(goal) && isempty(block.knob) && hasLowWay(block, goal, others), trials = [false, true]; end
  [is_low, rises] = ndgrid(trials, way.rises);
  is_plain = isempty(block.knob) && isempty(block.parts);
  % Ends that proved beyond reach, at the block and at the goal: the arm, the yaw of its hand, and the heights of its tool.
  beyond = {zeros(4, 0), zeros(3, 0)};
  for trial = [is_low'(:)'; rises'(:)']
    for arm = nearestFirst(able, block.position(1) + goal.position(1))
      bottom = goal.position(3) - goal.size(3) / 2;
      extent = target.position(3) + target.size(3) / 2 - bottom;
      height = transferHeight(arm, [others, held], bottom, extent) + trial(2);
      if isDragged(goal)
        height = block.position(3) + block.size(3) / 2 + constants().motion_planning.drag_tool_height;
      end
      lift = height;
      if trial(1), lift = block.position(3) + block.size(3) + constants().motion_planning.clearance; end
      q = sensor.arms(arm.index).joints(:)';
      has_failed = arrayfun(@(yaw) hasFailed(newGrasp(held.position, arm, yaw), failures), grasp_yaws);
      [at_start, at_goal] = ndgrid(grasp_yaws(~has_failed), place_yaws);
      for yaws = shuffled([at_start(:)'; at_goal(:)'], way.seed)
        ends = {[arm.index; yaws(1); lift; height], [arm.index; yaws(2); height]};
        if any(all(beyond{1} == ends{1})) || any(all(beyond{2} == ends{2})), continue; end
        % The object turns with the hand; it may look the same after some turns.
        turned = block;
        turned.yaw = block.yaw + yaws(2) - yaws(1);
        if ~is_plain && ~isTurnedTo(turned, goal), continue; end
        [actions, is_beyond] = planArmPickAndPlace(arm, held, yaws(1), target, yaws(2), height, lift, away, others, q);
        if ~isempty(actions), return; end
        for k = find(is_beyond), beyond{k}(:, end + 1) = ends{k}; end
      end
    end
  end
end

function yes = isTurnedTo(block, goal)
% Returns true if a block at the place of a goal would look as wanted there, and its held part be where that of the goal is.
  c = constants().motion_planning;
  block.position = goal.position;
  away = heldPart(block).position - heldPart(goal).position;
  yes = abs(yawDifference(block, goal.yaw)) < c.same_yaw_rad && norm(away(1:2)) < c.same_held_distance;
end
