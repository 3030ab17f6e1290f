function some = onwardArms(arms, block, goal)
% Returns the arms that can bring a block to a goal from wherever it is put: those that surely reach it there; all if none does,
% if it is dragged there, or if there is no goal ([]).
  some = arms;
  if isempty(goal) || isDragged(goal), return; end
  block.position = goal.position;
  block.yaw = goal.yaw;
  found = reaching(arms, block);
  if ~isempty(found), some = found; end
end
