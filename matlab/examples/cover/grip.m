function actions = grip(arm, velocity, opening)
% Returns the action to move a gripper until it has an opening, or stands still. Below 0, the velocity closes it.
  actions = {struct('kind', 'grip', 'arm', arm, 'velocity', velocity, 'opening', opening)};
end
