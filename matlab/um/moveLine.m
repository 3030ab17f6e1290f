function path = moveLine(robot, arm, before, goal)
% A straight way from the end of another path to a pose; [] if there is none, or if it leads past a
% stretched arm, where it would take too long.
  c = constants().carry;
  names = {'left', 'right'};
  path = smileMoveLine(robot, names{arm}, before.positions(end, :), goal, 'speed', c.speed);
  if ~isempty(path) && path.duration > c.longest_line_s, path = []; end
end
