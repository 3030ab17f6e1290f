function yes = stoodFromTheStart(demo, steps)
% Returns true if steps lead to what stood when the demonstration began, elsewhere: shifted, and rotated about the
% vertical.
  yes = ~isempty(steps) && all(arrayfun(@isFreeStep, steps));
  if ~yes, return; end
  c = constants().task_model;
  [~, n] = ismember({steps.name}, demo.ids);
  first = demo.start(n, :);
  last = demo.final(n, :);
  turns = (last(:, 6) - first(:, 6)) * pi / 180;
  before = first(:, 1:2) - mean(first(:, 1:2), 1);
  after = last(:, 1:2) - mean(last(:, 1:2), 1);
  % The rotation that fits best; what stands on one point, as a single object does, has only its own.
  angle = atan2(sum(before(:, 1) .* after(:, 2) - before(:, 2) .* after(:, 1)), sum(sum(before .* after)));
  if max(vecnorm(before, 2, 2)) < c.same_place, angle = turns(1); end
  errors = vecnorm(rotated(before, angle) - after, 2, 2);
  yes = max(errors) < c.same_place && max(abs(last(:, 3) - first(:, 3))) < c.same_place;
  for k = 1:numel(steps)
    turn = yawDifference(steps(k), steps(k).yaw - turns(k) + angle);
    yes = yes && abs(turn) < c.same_turn_degrees * pi / 180;
  end
end

function yes = isFreeStep(step)
% Returns true unless the place of a step is determined by what is below it or was there, or it leads to another face.
  yes = ~step.stays && isempty(step.takesPlaceOf) && isempty(step.aside) && ~isDragged(step) && isempty(step.startSize);
end
