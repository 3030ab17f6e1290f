function [actions, building] = decide(building, sensor, eye, robot)
% Looks where the blocks are and says what to do next; {} when all is built or nothing helps.
  most_tries = 4;
  actions = {};
  seen = findBlocks(sensor.rgbVision, eye, building.steps);
  if ~building.hasSite
    building = chooseSite(building, seen, robot);
    if ~building.hasSite, return; end
  end

  [building, used] = compare(building, seen);
  k = find(~building.done, 1);
  if isempty(k)
    building.summary = sprintf('built, as seen within %.2f units and %.1f degrees', ...
                               max(building.miss(:, 1)), max(building.miss(:, 2)) * 180 / pi);
    return
  end
  step = building.steps(k);
  if building.tries(k) >= most_tries || building.tidied >= 3 * most_tries
    building.summary = sprintf('gave up at %s after %d tries', describeStep(step), building.tries(k));
    return
  end

  free = seen(~used);
  [block, aside] = chooseBlock(step, free);
  if isempty(block)
    building.looks = building.looks + 1;
    if building.looks > 3
      building.summary = sprintf('cannot see %s', describeStep(step));
    else
      actions = {struct('kind', 'look')};
    end
    return
  end
  building.looks = 0;

  others = seen(arrayfun(@(other) ~isequal(other, block), seen));
  goal = [];
  if ~aside
    [actions, reason] = planCarry(robot, block, step, others, sensor.jointAngles);
    if ~isempty(actions)
      building.tries(k) = building.tries(k) + 1;
      return
    end
    goal = step;
  end
  % It is in the way, or no arm reaches both places: to somewhere else first.
  [actions, reason] = planAside(robot, block, others, building, sensor.jointAngles, goal);
  building.tidied = building.tidied + 1;
  if isempty(actions)
    building.summary = sprintf('gave up at %s: %s', describeStep(step), reason);
  end
end
