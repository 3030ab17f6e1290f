function actions = goAside(robot, arm, motions, aside)
% Returns the actions of an arm that goes aside at the end of these motions.
  q = motions{end}.positions(end, :);
  actions = follow(arm, {smileMoveJoints(robot, robot.arms{arm}, [q; aside(arm, :)], 'speed', 0.7)});
end
