function [actions, place, reason] = planReturning(block, step, is_back, state, arms, sensor)
% Plans to put a block that comes back aside, or back: a 1xN cell of actions; {} and a reason if no arm can. It passes over all
% as high as in the demonstration, and turns as there.
%   step   of the block, whose aside is in this scene
%   place  the block where it will be
  actions = {};
  place = block;
  reason = 'it is put aside already';
  places = {asBlocks(step), step.aside.place};
  distances = cellfun(@(it) norm(block.position - it.position), places);
  is_aside = distances(2) < distances(1);
  if is_aside && ~is_back, return; end
  here = places{1 + is_aside};
  there = places{2 - is_back};
  block.yaw = directed(block, here.yaw);
  place.position = there.position;
  place.yaw = there.yaw;
  % Only what is as high as the fingers is in their way.
  lowest = min(block.position(3), place.position(3)) + block.size(3) / 2 - constants().clearance.hand_above_top;
  is_other = arrayfun(@(it) it.position(3) + it.size(3) / 2 > lowest && ~isSameKind(it, step), state.known);
  others = state.known(is_other);
  height = step.aside.height + block.size(3) / 2;
  away = besideTouching(place, others);
  [able, reason] = ableArms(arms, block, block.size(2), state.failures, 'no arm reaches both its place and its goal');
  for arm = nearestFirst(able, block.position(1))
    tool_height = height - gripDepth(arm, block.size(3));
    q = sensor.arms(arm.index).joints(:)';
    place_yaws = graspYaws(place, others);
    for grasp_yaw = graspYaws(block, others)
      if hasFailed(newGrasp(block.position, arm, grasp_yaw), state.failures), continue; end
      for place_yaw = place_yaws
        turn = place_yaw - grasp_yaw - (place.yaw - block.yaw);
        if abs(sin(turn / 2)) > 0.01, continue; end
        actions = planArmPickAndPlace(arm, block, grasp_yaw, place, place_yaw, tool_height, tool_height, away, others, q);
        if ~isempty(actions), return; end
      end
    end
  end
end
