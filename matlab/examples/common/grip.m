function actions = grip(arm, velocity, opening)
% Returns the action of a gripper that moves until it has an opening or stands still. A negative velocity closes it: a
% gripper that holds a tool uses it.
  actions = {struct('kind', 'grip', 'arm', arm, 'velocity', velocity, 'opening', opening)};
end
