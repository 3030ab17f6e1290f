function [actions, is_beyond] = planArmPickAndPlace(arm, block, grasp_yaw, goal, place_yaw, height, lift, away, others, q)
% Plans to bring a block to a goal with one arm and given yaws of the gripper; {} if that arm cannot. is_beyond, 1x2 logical: whether
% it finds no joint angles at the block with that yaw, lift and height, or else none at the goal with that yaw and height.
%   grasp_yaw, place_yaw  directions from finger to finger [rad]
%   height                of the tool between both places [units]
%   lift                  of the tool over the block; below `height`, the way leads over the middle between
%                         both places [units]
%   away                  how far beside its place it is lowered first, x y [units]; [] if it is dragged there, not lifted
%   others                obstacles, as blocks
%   q                     its joint angles, 1xn [rad]
  c = constants().motion_planning;
  width = block.size(2);
  opening = min(width + c.opening_margin, arm.opening);
  depth = min([gripDepth(arm, block.size(3)), block.depth - arm.reach, goal.depth - arm.reach]);
  offset = [0, 0, block.size(3) / 2 - depth];  % of the tool, from the block's center
  from = toolPose(arm, block.position + offset, grasp_yaw, width);
  to = toolPose(arm, goal.position + offset + [0, 0, c.place_height_margin], place_yaw, width);
  over_from = atHeight(from, lift);
  over_to = atHeight(to, height);
  via = {};
  if lift < height
    via = {from};
    via{1}(1:3, 4) = [(from(1:2, 4) + to(1:2, 4)) / 2; height];
  end
  % Without a way to the block, none is looked for that goes on to the goal.
  actions = {};
  to_block = [via, {over_from, from}];
  is_beyond = [isBeyond(arm, to_block), false];
  if is_beyond(1), return; end

  is_dragged = isempty(away);
  if is_dragged
    transfer = {to};
  else
    transfer = [{over_from}, via, {shifted(over_to, away), shifted(to, away), to}];
    if ~any(away), transfer(end) = []; end
  end
  taken = noBlocks();
  if ~is_dragged, taken = block; end
  path = planPathThrough(arm, [to_block, transfer, {over_to}], others, q, goal, taken);
  if isempty(path)
    % From another posture, it may avoid the torso at the goal.
    is_beyond(2) = isBeyond(setfield(arm, 'hasTorso', false), {over_to, to});
    return
  end

  follow = cellfun(@(it) struct('kind', 'follow', 'arm', arm, 'path', it), path, 'UniformOutput', false);
  open = struct('kind', 'open', 'arm', arm, 'to', opening);
  attempt = newGrasp(block.position, arm, grasp_yaw);
  grasp = struct('kind', 'grasp', 'arm', arm, 'width', width, 'grasp', attempt);
  n = numel(to_block);
  if ~is_dragged, follow{n + 1}.kind = 'lift'; end
  actions = [{open}, follow(1:n), {grasp}, follow(n + 1:end - 2), {open}, follow(end - 1:end), ...
             {struct('kind', 'observe')}];
end

function yes = isBeyond(arm, poses)
% Returns true if joint angles for a sequence of tool poses are found from none of an arm's starts.
  yes = false;
  for start = arm.starts'
    if ~isempty(solvePoses(arm, poses, start')), return; end
  end
  yes = true;
end

function pose = shifted(pose, displacement)
% Returns a pose displaced by x, y, 1x2 [units].
  pose(1:2, 4) = pose(1:2, 4) + displacement';
end
