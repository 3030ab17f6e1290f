function actions = switchTo(wanted, x, side, attempts, rack, robot, aside, sensor, aux)
% Returns the actions that bring the lamp of the slot at x into a state. `side` is that of the raised button of its
% switch, -1 or 1; each press raises the other one.
  lamp = lampAt(x, rack, sensor, aux);
  printf('%.1f s: the lamp is %s\n', sensor.simTime, lamp);
  actions = {};
  if strcmp(lamp, wanted), return, end
  if attempts == 0, error('the lamp is %s, expected %s', lamp, wanted); end
  % Closed fingers push the button, from as high as the arm can.
  button = movedPlace(rack, x + 0.42 * side, -1.5);
  tip = tipLength(robot, 1);
  for height = [2.2, 1]
    for across = [1, -1]
      above = poseAt(pointAt(button, 0, 0, height + tip), across * button.x);
      down = poseAt(pointAt(button, 0, 0, 0.4 + tip), across * button.x);
      [arm, motions] = planPath(robot, aside, {'joints', above; 'line', down; 'line', above});
      if ~isempty(arm), break, end
    end
    if ~isempty(arm), break, end
  end
  if isempty(arm), error('no arm reaches the switch'); end
  actions = [grip(arm, -1, -Inf), follow(arm, motions), grip(arm, 1, Inf), ...
             goAside(robot, arm, motions, aside), ...
             look(@(s, a) switchTo(wanted, x, -side, attempts - 1, rack, robot, aside, s, a))];
end
