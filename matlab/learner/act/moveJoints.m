function path = moveJoints(arm, waypoints)
% Plans a path of an arm through joint waypoints, Nxn [rad]: see smileMoveJoints.
  path = smileMoveJoints(arm.robot, arm.name, waypoints, 'speed', constants().motion_planning.speed);
end
