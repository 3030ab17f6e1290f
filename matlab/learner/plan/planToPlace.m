function [actions, reason] = planToPlace(arms, block, place, others, sensor, goal, failures)
% Plans the actions that bring a block to a place from which an arm can move it to a goal, if there is one: a 1xN cell; {} and
% a reason if there are none.
%   others, goal, failures  as in planTemporaryPlacement
  [actions, reason] = planPickAndPlace(arms, block, place, others, sensor, failures);
  if isempty(actions) || isempty(goal), return; end
  [onward, reason] = planPickAndPlace(arms, place, goal, others, sensor, []);
  if isempty(onward), actions = {}; end
end
