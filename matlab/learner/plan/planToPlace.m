function [actions, reason] = planToPlace(arms, block, place, others, sensor, goal, failures)
% Plans the actions that bring a block to a place from which an arm can move it to a goal, if there is one: a 1xN cell; {} and
% a reason if there are none, which is empty if it can only not be moved on from there.
%   others, goal, failures  as in planTemporaryPlacement
  actions = {};
  reason = '';
  if ~isempty(goal) && isempty(planPickAndPlace(arms, place, goal, others, sensor, [])), return; end
  [actions, reason] = planPickAndPlace(arms, block, place, others, sensor, failures);
end
