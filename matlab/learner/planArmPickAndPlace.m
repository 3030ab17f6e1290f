function actions = planArmPickAndPlace(robot, arm, block, grasp_yaw, goal, place_yaw, height, others, q)
% Plans to bring a block to a goal with one arm and given yaws of the gripper; {} if that arm cannot.
%   grasp_yaw, place_yaw  directions from finger to finger [rad]
%   height                of the tool between both places [units]
%   others                obstacles, as blocks
%   q                     2x7, joint angles of the arms [rad]
  c = constants().motion_planning;
  opening = block.size(2) + c.opening_margin;
  offset = [0, 0, block.size(3) / 2 - c.grip_below_top];  % of the tool, from the block's center
  from = toolPose(block.position + offset, grasp_yaw);
  to = toolPose(goal.position + offset + [0, 0, c.place_height_margin], place_yaw);
  over_from = from;
  over_from(3, 4) = height;
  over_to = to;
  over_to(3, 4) = height;
  if ~isDragged(goal)
    path = planPathThrough(robot, arm, {over_from, from, over_from, over_to, to, over_to}, others, q);
  else  % a dragged object is not lifted
    path = planPathThrough(robot, arm, {over_from, from, to, over_to}, others, q);
  end
  actions = {};
  if isempty(path), return; end

  follow = cellfun(@(it) struct('kind', 'follow', 'arm', arm, 'path', it), path, 'UniformOutput', false);
  open = struct('kind', 'open', 'arm', arm, 'to', opening);
  grasp = struct('kind', 'grasp', 'arm', arm, 'width', block.size(2));
  actions = [{open}, follow(1:2), {grasp}, follow(3:end - 2), {open}, follow(end - 1:end), ...
             {struct('kind', 'observe')}];
end
