function path = moveLine(robot, arm, before, goal)
% A straight way from the end of another path to a pose; [] if there is none.
  names = {'left', 'right'};
  path = smileMoveLine(robot, names{arm}, before.positions(end, :), goal, 'speed', 0.9);
end
