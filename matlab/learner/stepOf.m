function step = stepOf(demo, n, appearance, attention)
% Returns the step of a carried object of a demonstration, at its final place: see newStep.
%   n           number of the object
%   appearance  the block at its first place, as from measureObjects
%   attention   as in aux
  c = constants();
  step = newStep(appearance, demo.ids{n});
  step.position = demo.final(n, 1:3);
  [step.size, step.yaw] = restingAt(appearance, demo.final(n, :));
  if step.size(2) > c.blocks.equal_sides * step.size(1)
    step.size(1:2) = step.size([2, 1]);
    step.yaw = step.yaw + pi / 2;
  end
  properties = attended(attention, step.name);
  if ~isempty(properties) && ~any(strcmp(properties, 'color')), step.color = []; end
  away = abs(demo.final(n, :) - demo.start(n, :));
  step.beginsThere = max(away(1:3)) < c.task_model.max_rest_error && max(away(4:6)) < c.task_model.max_rest_degrees;
end
