function [actions, building] = decide(building, sensor, eye, robot)
% Looks where the blocks are and says what to do next; {} when all is built or nothing helps.
  c = constants().decide;
  actions = {};
  container = building.container;
  if ~building.hasSite, container = []; end  % where it stands here is not known yet
  picture = sensor.rgbVision;
  seen = findBlocks(picture, eye, [asBlocks(building.steps), building.strangers], container);
  if ~building.hasSite || building.stuck > 0
    building.strangers = [building.strangers, findStrangers(picture, eye, [seen, building.known])];
    seen = findBlocks(picture, eye, [asBlocks(building.steps), building.strangers], container);
  end
  building.known = remember(building.known, seen, picture, eye);
  if ~building.hasSite
    building = chooseSite(building, robot, picture, eye);
    if ~building.hasSite, return; end
  end

  [building, used] = compare(building);
  open = openSteps(building);
  if isempty(open)
    building.summary = sprintf('built, as seen within %.2f units and %.1f degrees', ...
                               max(building.miss(:, 1)), max(building.miss(:, 2)) * 180 / pi);
    return
  end

  % The next step in the order shown; when nothing helps there, one of those that can be done as well.
  k = open(1 + mod(building.stuck, numel(open)));
  reason = 'it cannot be seen';
  if building.tries(k) >= c.most_tries
    reason = sprintf('%d tries were not enough', c.most_tries);
  elseif building.tidied >= c.most_tidied
    reason = sprintf('%d blocks had to be put somewhere else already', c.most_tidied);
  else
    for move = proposeMoves(building, k, find(~used))
      [actions, place, reason] = planMove(building, k, move, eye, robot, sensor.jointAngles);
      if isempty(actions), continue; end
      building.tidied = building.tidied + ~isempty(place);
      building.tries(k) = building.tries(k) + isempty(place);
      building.known(move.block) = [];
      building.known = [building.known, place];
      building.stuck = 0;
      return
    end
  end
  if building.stuck == 0, building.trouble = [describeStep(building.steps(k)), ': ', reason]; end
  building.stuck = building.stuck + 1;
  if building.stuck > numel(open) + 1
    building.summary = ['gave up at ', building.trouble];
  else
    actions = {struct('kind', 'look')};
  end
end

function open = openSteps(building)
% Those that are not done and stand on what is done, in the order shown.
  open = find(~building.done);
  open = open(arrayfun(@(k) all(building.done(building.steps(k).on)), open));
end

function [actions, place, reason] = planMove(building, k, move, eye, robot, q)
% Straight to its goal, if it has one and an arm reaches both; else to somewhere else first, if need be
% where the building will stand later.
%   place  the block where it will lie on the table, even if it is hidden there; a 1x0 struct array for
%          one that is built in: there it must be seen
  block = building.known(move.block);
  others = [building.known([1:move.block - 1, move.block + 1:end]), supportOf(block), ...
            wallsOf(building.container)];
  steps = building.steps;
  container = asBlocks(building.container);
  sites = {[asBlocks(steps), container]};
  actions = {};
  place = noBlocks();
  if ~isempty(move.goal)
    sites{2} = [asBlocks(steps(building.done)), container];
    [actions, reason] = planCarry(robot, block, move.goal, others, q);
  elseif any(overlap(gripRoom(steps(k)), footprint(block, 0)))
    sites{2} = [asBlocks(steps([find(building.done), k])), container];
  end
  if isempty(actions)
    [actions, place, reason] = planAside(robot, eye, block, others, sites, q, move.goal);
  end
end
