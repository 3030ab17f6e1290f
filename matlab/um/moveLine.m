function path = moveLine(robot, arm, before, goal)
% A straight way from the end of another path to a pose; [] if there is none, or if it leads past a
% stretched arm, where it would take too long.
  longest = 6;  % s
  names = {'left', 'right'};
  path = smileMoveLine(robot, names{arm}, before.positions(end, :), goal, 'speed', 0.9);
  if ~isempty(path) && path.duration > longest, path = []; end
end
