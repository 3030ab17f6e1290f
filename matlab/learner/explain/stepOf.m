function step = stepOf(demo, n, appearance, attention)
% Returns the step of a carried object of a demonstration, at its final place: see newStep.
%   n           number of the object
%   appearance  the block at its first place, as from measureObjects
%   attention   as in aux
  step = newStep(appearance, demo.ids{n});
  step.position = demo.final(n, 1:3);
  [step.size, step.yaw] = restingAt(appearance, demo.final(n, :));
  has_outline = ~isempty(step.outline);
  if step.size(2) > constants().blocks.equal_sides * step.size(1) && ~has_outline
    step.size(1:2) = step.size([2, 1]);
    step.yaw = step.yaw + pi / 2;
    step.parts = turnedParts(step.parts, pi / 2);
  end
  began = [sort(appearance.size(1:2), 'descend'), appearance.size(3)];
  if ~has_outline && ~sameSize(began, step.size), step.startSize = began; end
  step.start = demo.start(n, 1:3);
  properties = attended(attention, step.name);
  if ~isempty(properties) && ~any(strcmp(properties, 'color')), step.color = []; end
  step.beginsThere = isSamePose(demo.start(n, :), demo.final(n, :));
end
