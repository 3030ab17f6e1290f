% Callback: continues the first action. After the last one, a picture of the table determines the next.
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
  state.notes(end + 1) = asNote('contradicted', status);
  if num_retreats == 0, state = rememberFailure(state, actions, status); end
  num_retreats = num_retreats + 1;
  if num_retreats <= constants().task_planning.max_retreats
    q = sensor.arms(action.arm.index).joints(:)';
    actions = retreat(action.arm, q, num_retreats == 1);
  else
    actions = {struct('kind', 'observe')};  % all may be done already
  end
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
  if state.claim.done, word = 'done'; else, word = 'gave up'; end
  aux.claim = [word, ': ', state.claim.reason];
  fprintf('%5.1f s: %s\n', sensor.simTime, aux.claim);
  aux.exit = true;
  actions = {struct('kind', 'observe')};
end
