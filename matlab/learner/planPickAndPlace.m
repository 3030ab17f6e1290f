function [actions, reason] = planPickAndPlace(robot, block, goal, others, q)
% Plans the actions that bring a block to a goal (both with position, yaw and size) and end with an
% observation; {} and a reason if no arm can do it.
%   others  obstacles, as blocks
%   q       2x7, joint angles of the arms [rad]
  actions = {};
  grasp_yaws = graspYaws(block, others);
  place_yaws = graspYaws(goal, others);
  reason = 'there is no room for the fingers';
  if isempty(grasp_yaws) || isempty(place_yaws), return; end

  height = transferHeight([others, block], goal);
  if isDragged(goal)
    height = block.position(3) + block.size(3) / 2 + constants().motion_planning.drag_tool_height;
  end
  arms = [1, 2];
  if block.position(1) + goal.position(1) > 0, arms = [2, 1]; end
  for arm = arms
    for place_yaw = place_yaws
      for grasp_yaw = grasp_yaws
        actions = planArmPickAndPlace(robot, arm, block, grasp_yaw, goal, place_yaw, height, others, q);
        if ~isempty(actions), return; end
      end
    end
  end
  reason = 'no arm reaches both its place and its goal';
end

function height = transferHeight(blocks, goal)
% Returns the height of the tool between two places [units]: the held block passes over all others, and so
% do the empty fingers, also over the placed block.
  c = constants().motion_planning;
  highest = max(arrayfun(@(block) block.position(3) + block.size(3) / 2, blocks));
  bottom = goal.position(3) - goal.size(3) / 2;
  height = max(max(highest, bottom) + goal.size(3), ...
               max(highest, bottom + goal.size(3)) + c.tip_below_tool) + c.clearance;
end
