% Callback: continues the first action. After the last one, a picture of the table determines the next.
if isempty(state), return; end  % it ended at the beginning
[joints, sensor] = correctJoints(joints, sensor, aux.tickSeconds);
[action, motor, status, aux.imageSeconds, sensor] = executeAction(actions{1}, sensor, aux);
joints.told = arrayfun(@(arm) arm.velocities, motor.arms, 'UniformOutput', false);
actions{1} = action;

if strcmp(status, 'done')
  actions(1) = [];
  if strcmp(action.kind, 'look'), state = seeFromHand(state, sensor, action.arm); end
  if isempty(actions)
    [actions, state] = chooseActions(state, sensor, eye, hands);
    if num_retreats > constants().task_planning.max_retreats && isempty(state.claim)
      state = giveUp(state, 'because the arm is stuck');
    end
    num_retreats = 0;
  end
elseif ~strcmp(status, 'busy')
  [actions, state, num_retreats] = recover(status, sensor, actions, state, num_retreats);
end
aux.cameras = {};  % pictures of the hands take time
if ~isempty(actions) && strcmp(actions{1}.kind, 'look'), aux.cameras = {actions{1}.arm.camera}; end
if ~isempty(state.notes)
  % Tells the notes that were not told yet: those about actions also in the log.
  aux.notes = strcat({state.notes.word}, {': '}, {state.notes.text});
  aux.noteTops = topsOf(state.notes);
  if any(~cellfun(@isempty, {state.notes.camera})), aux.noteCameras = {state.notes.camera}; end
  is_logged = ~ismember({state.notes.word}, {'plan', 'saw'});
  for note = aux.notes(is_logged), fprintf('%5.1f s: %s\n', sensor.simTime, note{1}); end
  state.notes(:) = [];
end
if ~isempty(state.claim)
  aux = endWith(state.claim, sensor.simTime, aux);
  actions = {struct('kind', 'observe')};
end
