function [actions, state, problem] = planDrive(drive, alignment, surface, state, arms, sensor)
% Plans what a tool turns (see newPress): takes it, turns one fastener after the other, and puts it back. A 1xN cell of actions;
% {} and a problem if that is impossible. state.grasp is that of the tool.
%   alignment, surface  see align, surfaceOf
  actions = {};
  state.grasp = [];
  k = find(arrayfun(@(it) isSameKind(it, drive.tool), state.known), 1);
  problem = [drive.tool.name, ' is not visible'];
  if isempty(k), return; end
  % Should it fail, the tool is no longer where it was.
  tool = state.known(k);
  state.known = [state.known([1:k - 1, k + 1:end]), tool];
  alignment = refinedAt(drive, alignment, surface, state.shown);
  turns = drive.turns;
  for k = 1:numel(turns)
    turns(k).place(1:2) = rotated(turns(k).place(1:2) - alignment.place, -alignment.angle);
  end
  near = [surface.points(:, 1:2), zeros(rows(surface.points), 3)];
  around = surroundingsOf(surface.points(~overlap(footprint(tool, constants().uses.around), near), :));
  height = drive.height - drive.tool.position(3) + tool.position(3);
  [able, problem] = ableArms(arms, tool, tool.size(2), state.failures, 'no arm brings it there and back', drive.tool.name);
  for arm = nearestFirst(able, tool.position(1))
    attempt = newGrasp(tool.position, arm, 0);
    if hasFailed(attempt, state.failures), continue; end
    isClear = @(path) avoids(around, arm, path);
    actions = planArmDrive(arm, tool, height, turns, sensor.arms(arm.index).joints(:)', isClear);
    if isempty(actions), continue; end
    state.grasp = attempt;
    problem = '';
    return
  end
end
