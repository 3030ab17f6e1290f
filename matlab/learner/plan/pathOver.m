function path = pathOver(arm, q, pose)
% Returns a path of an arm over the table from joint angles to a pose: a straight one, or any that the joints can do; [] if
% there is none.
  path = turningLine(arm, struct('positions', q), pose);
  if ~isempty(path), return; end
  goal = armInverse(arm, pose, q, 'anyTurn', true, 'maxIterations', constants().motion_planning.ik_iterations);
  if ~isempty(goal), path = moveJoints(arm, [q; goal]); end
end
