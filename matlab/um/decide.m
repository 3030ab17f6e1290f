function [actions, building] = decide(building, sensor, eye, robot)
% Looks where the blocks are and says what to do next; {} when all is built or nothing helps.
  most_tries = 4;
  actions = {};
  seen = findBlocks(sensor.rgbVision, eye, building.steps);
  building.known = remember(building.known, seen, sensor.rgbVision, eye);
  if ~building.hasSite
    building = chooseSite(building, robot);
    if ~building.hasSite, return; end
  end

  [building, used] = compare(building);
  k = find(~building.done, 1);
  if isempty(k)
    building.summary = sprintf('built, as seen within %.2f units and %.1f degrees', ...
                               max(building.miss(:, 1)), max(building.miss(:, 2)) * 180 / pi);
    return
  end
  name = describeStep(building.steps(k));
  if building.tries(k) >= most_tries || building.tidied >= 20
    building.summary = sprintf('gave up at %s, after %d tries', name, building.tries(k));
    return
  end

  reason = 'it cannot be seen';
  for move = proposeMoves(building, k, find(~used))
    [actions, reason] = planMove(building, move, eye, robot, sensor.jointAngles);
    if isempty(actions), continue; end
    if isempty(move.goal), building.tidied = building.tidied + 1; end
    building.tries(k) = building.tries(k) + ~isempty(move.goal);
    building.known(move.block) = [];  % where it will be, the next look tells
    building.looks = 0;
    return
  end
  building.looks = building.looks + 1;
  if building.looks > 2
    building.summary = sprintf('gave up at %s: %s', name, reason);
  else
    actions = {struct('kind', 'look')};
  end
end

function [actions, reason] = planMove(building, move, eye, robot, q)
% Straight to its goal, if it has one and an arm reaches both; else to somewhere else first.
  block = building.known(move.block);
  others = building.known([1:move.block - 1, move.block + 1:end]);
  actions = {};
  if ~isempty(move.goal), [actions, reason] = planCarry(robot, block, move.goal, others, q); end
  if isempty(actions)
    [actions, reason] = planAside(robot, eye, block, others, building, q, move.goal);
  end
end
