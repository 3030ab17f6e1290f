function path = moveLine(arm, before, goal)
% Plans a straight line of an arm from the end of another path to a pose, 4x4; [] if there is none, or if it
% passes a stretched arm, where it would take too long.
  c = constants().motion_planning;
  path = smileMoveLine(arm.robot, arm.name, before.positions(end, :), goal, 'speed', c.speed);
  if ~isempty(path) && path.duration > c.max_line_s, path = []; end
end
