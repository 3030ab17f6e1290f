% Goes on with the first of the actions. After the last one, a look at the table decides what is next.
[action, motor, status] = carryOut(actions{1}, sensor);
actions{1} = action;

if strcmp(status, 'done')
  actions(1) = [];
  if isempty(actions)
    is_recovering = false;
    [actions, building] = decide(building, sensor, eye, robot);
    if isempty(actions)
      fprintf('%5.1f s: %s\n', sensor.simTime, building.summary);
      aux.exit = true;
      actions = {struct('kind', 'look')};
    end
  end
elseif ~strcmp(status, 'busy')
  fprintf('%5.1f s: %s\n', sensor.simTime, status);
  if is_recovering, error('the arm does not get free'); end
  actions = retreat(robot, action.arm, sensor.jointAngles);
  is_recovering = true;
end
