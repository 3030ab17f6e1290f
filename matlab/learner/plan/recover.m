function [actions, state, num_retreats] = recover(status, sensor, actions, state, num_retreats)
% Remembers how an action failed, and plans that its arm retreats; after too many retreats, only another look.
%   status        of the first of the actions, as from executeAction
%   num_retreats  number of successive retreats
  state.notes(end + 1) = asNote('contradicted', status);
  if num_retreats == 0, state = rememberFailure(state, actions, status); end
  arm = actions{1}.arm;
  num_retreats = num_retreats + 1;
  if num_retreats <= constants().task_planning.max_retreats
    actions = retreat(arm, sensor.arms(arm.index).joints(:)', num_retreats == 1);
  else
    actions = {struct('kind', 'observe')};  % all may be done already
  end
end
