function actions = look(next)
% Returns the action that waits for a new picture. next(sensor, aux) then returns the actions that take its place.
  actions = {struct('kind', 'look', 'next', next)};
end
