function path = turningLine(arm, before, pose)
% Returns a straight path of an arm from the end of another one to a pose, on which the tool may turn about its axis; [] if
% there is none.
  c = constants().motion_planning;
  path = smileMoveLine(arm.robot, arm.name, before.positions(end, :), pose, 'speed', c.speed, 'anyTurn', true);
  if ~isempty(path) && path.duration > c.max_line_s, path = []; end
end
