function actions = carry(block, goal, seen, shoulders)
% The actions that bring a block to its goal and end with a look; {} if no arm can.
  highest = 1;
  for i = 1:numel(seen)
    if ~isempty(seen{i}), highest = max(highest, seen{i}.position(3)); end
  end
  arm = armFor(block.position, goal.position, highest, shoulders);
  actions = {};
  if arm == 0, return; end

  shoulder = shoulders(arm, :);
  over_block = highPosture(block.position, block.yaw, highest, shoulder, arm);
  take = holdingPosture(block.position, block.yaw, shoulder, arm);
  over_goal = highPosture(goal.position, goal.yaw, max(highest, goal.position(3)), shoulder, arm);
  put = holdingPosture(goal.position + [0, 0, 0.01], goal.yaw, shoulder, arm);
  park = postureOf(parkedAngles(arm), arm);
  actions = {move(arm, over_block), move(arm, take), grip('close', arm), move(arm, over_block), ...
             move(arm, over_goal), move(arm, put), grip('open', arm), move(arm, over_goal), ...
             move(arm, park), struct('kind', 'look')};
end

function action = move(arm, posture)
  action = struct('kind', 'move', 'arm', arm, 'to', posture);
end

function action = grip(kind, arm)
  action = struct('kind', kind, 'arm', arm);
end
