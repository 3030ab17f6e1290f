function actions = cutString(attempts, robot, aside, sensor, aux)
% Returns the actions that cut the string while the weight hangs: the scissors are taken, closed at the string, and put
% back; then the program looks again.
  actions = {};
  weight = pointsOf([242 177 52], sensor, aux);
  if size(weight, 1) < 50, error('no weight is visible'); end
  if median(weight(:, 3)) < 1.5
    disp('the string is cut');
    return
  end
  if attempts == 0, error('the weight still hangs'); end
  [string, legs] = findString(sensor, aux);
  paths = cuttingPaths(findScissors(sensor, aux), string, legs);
  actions = look(@(s, a) useScissors(paths, attempts, robot, aside));
end
