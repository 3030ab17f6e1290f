function path = moveLine(robot, arm, before, goal)
% Plans a straight line from the end of another path to a pose, 4x4; [] if there is none, or if it passes a
% stretched arm, where it would take too long.
  c = constants().motion_planning;
  names = {'left', 'right'};
  path = smileMoveLine(robot, names{arm}, before.positions(end, :), goal, 'speed', c.speed);
  if ~isempty(path) && path.duration > c.max_line_s, path = []; end
end
