% Callback: continues the first action. After the last one, a picture of the table determines the next.
[action, motor, status, aux.imageSeconds] = executeAction(actions{1}, sensor, aux);
actions{1} = action;

if strcmp(status, 'done')
  actions(1) = [];
  if isempty(actions)
    is_recovering = false;
    [actions, state] = chooseActions(state, sensor, eye, hands);
    if isempty(actions)
      fprintf('%5.1f s: %s\n', sensor.simTime, state.summary);
      aux.exit = true;
      actions = {struct('kind', 'observe')};
    end
  end
elseif ~strcmp(status, 'busy')
  fprintf('%5.1f s: %s\n', sensor.simTime, status);
  if is_recovering, error('the arm is stuck'); end
  actions = retreat(action.arm, sensor.arms(action.arm.index).joints(:)');
  is_recovering = true;
end
