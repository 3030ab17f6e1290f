function actions = useScissors(paths, attempts, robot, aside)
% Returns the actions along the first of the paths that an arm can follow. Each is planned in a step of its own, so that
% no step takes long.
  if isempty(paths), error('no arm can bring the scissors to the string'); end
  [arm, motions] = planPath(robot, aside, paths{1});
  if isempty(arm)
    actions = look(@(s, a) useScissors(paths(2:end), attempts, robot, aside));
    return
  end
  printf('cutting with the %s arm\n', robot.arms{arm});
  actions = [follow(arm, motions(1:2)), grip(arm, -1, -Inf), follow(arm, motions(3:6)), grip(arm, -1, -Inf), ...
             follow(arm, motions(7:10)), grip(arm, 1, Inf), follow(arm, motions(11)), ...
             goAside(robot, arm, motions, aside), ...
             look(@(s, a) cutString(attempts - 1, robot, aside, s, a))];
end
