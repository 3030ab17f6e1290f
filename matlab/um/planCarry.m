function [actions, reason] = planCarry(robot, block, goal, others, q)
% The actions that bring a block to a goal (both with position, yaw and size) and end with a look; {} and
% a reason if no arm can.
%   others  blocks that are not to be touched
%   q       2x7, where the arms are [rad]
  actions = {};
  takes = fingerTurns(block, others);
  puts = fingerTurns(goal, others);
  reason = 'there is no room for the fingers';
  if isempty(takes) || isempty(puts), return; end

  height = carryingHeight([others, block], goal);
  if isDrawn(goal), height = block.position(3) + block.size(3) / 2 + constants().carry.drawing_height; end
  arms = [1, 2];
  if block.position(1) + goal.position(1) > 0, arms = [2, 1]; end
  for arm = arms
    for put = puts
      for take = takes
        actions = carryWith(robot, arm, block, take, goal, put, height, others, q);
        if ~isempty(actions), return; end
      end
    end
  end
  reason = 'no arm reaches both where it is and where it shall be';
end

function height = carryingHeight(all, goal)
% Of the tool [units]: a held block passes over everything, and empty fingers do, also over the block
% once it is placed.
  c = constants().carry;
  highest = max(arrayfun(@(block) block.position(3) + block.size(3) / 2, all));
  bottom = goal.position(3) - goal.size(3) / 2;
  height = max(max(highest, bottom) + goal.size(3), ...
               max(highest, bottom + goal.size(3)) + c.tip_below_tool) + c.clearance;
end
