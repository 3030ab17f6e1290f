% Goes on with the first of the actions. After the last one, a look at the table decides what is next.
if isempty(shoulders), shoulders = findShoulders(sensor); end

[action, motor, status] = carryOut(actions{1}, sensor);
actions{1} = action;

if strcmp(status, 'done')
  is_look = strcmp(action.kind, 'look');
  actions(1) = [];
  if is_look
    [actions, progress] = decide(steps, progress, sensor.rgbVision, camera, shoulders);
    is_recovering = false;
    if isempty(actions)
      fprintf('%s, %.1f s\n', summary(steps, progress), sensor.simTime);
      aux.exit = true;
    end
  end
elseif ~strcmp(status, 'busy')
  fprintf('%5.1f s: %s\n', sensor.simTime, status);
  if is_recovering, error('the arm does not get free'); end
  actions = retreat(action.arm, sensor);
  is_recovering = true;
end
