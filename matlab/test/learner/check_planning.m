function check_planning()
  red = [1, 0, 0]; green = [0, 1, 0]; blue = [0, 0, 1];
  cube = [1, 1, 1];
  steps = [asStep(block(red, cube, 0, -2, 0, 0)), asStep(block(green, cube, 0, -2, 1, 0)), ...
           asStep(block(green, cube, -3, -2, 0, 0))];
  state = initialTaskState(steps, []);
  state.known = [block(red, cube, 0.1, -2, 0, 0), block(red, cube, 0.05, -2, 0, pi), ...
                    block(red, cube, 0, -2, 1, 0)];
  [state, used] = assessProgress(state);
  check(isequal(used, logical([0, 1, 0])), 'a block close to its place is in it');
  check(isequal(state.done, logical([1, 0, 0])), 'so the step is done');

  state.known = [block(red, cube, 4, -3, 0, 0), block(red, cube, 3, -2, 0, 0), ...
                    block(blue, cube, 0.3, -2.2, 0, 0), block(blue, cube, 3, -2, 1, 0)];
  moves = proposeMoves(state, 1, 1:4);
  check(isequal([moves.block], [3, 4]), 'obstructing blocks come first, without a goal');
  check(all(cellfun(@isempty, {moves.goal})), 'neither goes to the place of a red one');
  moves = proposeMoves(state, 1, [1, 2, 4]);
  check(isequal([moves.block], [1, 4]), 'then a matching block; a covered one waits');
  check(isequal(cellfun(@isempty, {moves.goal}), logical([0, 1])), 'only red ones have a goal');

  tower = [block(red, cube, 0, -4, 0, 0), block(green, cube, 0, -4, 1, 0)];
  missing = block(blue, cube, 3, -2, 0, 0);
  known = updateBeliefs([tower(1), missing], tower(2), pictureOf(tower), robotEye());
  check(isequal(known, tower([2, 1])), 'a hidden block is remembered, a missing one is not');

  checkOrders(steps);
  checkEndsBeyondReach();
  checkBeyondReach();
  checkWays();
end

function checkOrders(steps)
% A seed varies the order of open steps.
  steps(2).on = 1;
  orders = zeros(0, 2);
  for seed = 1:20
    orders(end + 1, :) = openSteps(initialTaskState(steps, [], noPresses(), [], choicesOf(struct('variationOrder', seed))));
  end
  check(isequal(unique(orders, 'rows'), [1, 3; 3, 1]), 'a seed varies the order of what may be next');
end

function checkEndsBeyondReach()
% Of a block at x = -2 and its goal at x = 2, it is told which one is beyond reach. Only from the second start joint angles are found;
% at the goal, from there, the arm would touch the torso.
  global reached;
  eval('function pose = toolPose(arm, point, varargin), pose = eye(4); pose(1:3, 4) = point; end');
  eval('function path = planPathThrough(varargin), path = {}; end');
  eval(['function q = solvePoses(arm, poses, q), global reached; x = cellfun(@(it) it(1, 4), poses); ', ...
        'if q ~= 1 || ~all(ismember(x, reached)) || (arm.hasTorso && any(x == 2)), q = []; end; end']);
  remove = onCleanup(@() clear('-f', 'toolPose', 'planPathThrough', 'solvePoses'));
  arm = struct('index', 1, 'opening', 2, 'reach', 0.75, 'palm', 0.75, 'starts', [0; 1], 'hasTorso', true);
  start = block([1, 0, 0], [1, 1, 1], -2, -2, 0, 0);
  goal = block([1, 0, 0], [1, 1, 1], 2, -2, 0, 0);
  for it = {[-2, 2], -2, 2, []; [false, false], [false, true], [true, false], [true, false]}
    reached = it{1};
    [actions, is_beyond] = planArmPickAndPlace(arm, start, 0, goal, 0, 3, 3, [0, 0], noBlocks(), 0);
    check(isempty(actions) && isequal(is_beyond, it{2}), 'it is told which end is beyond reach');
  end
end

function checkBeyondReach()
% Yaws with which an arm does not reach a block, or its goal, are tried once for each way: the first ones are such.
  global tried;
  tried = zeros(0, 2);
  eval(['function [actions, is_beyond] = planArmPickAndPlace(~, ~, yaw, ~, place_yaw, varargin), global tried; ', ...
        'tried(end + 1, :) = [yaw, place_yaw]; actions = {}; is_beyond = tried(end, :) == tried(1, :); end']);
  remove = onCleanup(@() clear('-f', 'planArmPickAndPlace'));
  arm = struct('index', 1, 'opening', 2, 'reach', 0.75, 'palm', 0.75, 'foot', [0, 0]);
  start = block([1, 0, 0], [1, 1, 1], -2, -2, 0, 0);
  goal = block([1, 0, 0], [1, 1, 1], 2, -2, 0, 0);
  planPickAndPlace(arm, start, asStep(goal), noBlocks(), struct('arms', struct('joints', [])), []);
  check(rows(tried) == 2 * (1 + 3 * 3), 'each yaw of the others is tried with each, once more for a low way');
  check(isequal(sum(tried == tried(1, :)), [2, 1]), 'but none that is beyond reach: the block is lifted less then, the goal reached as before');
end

function checkWays()
% Seeds vary how a block is held and carried.
  eval('function [actions, is_beyond] = planArmPickAndPlace(~, ~, yaw, ~, ~, height, varargin), actions = [yaw, height]; is_beyond = [false, false]; end');
  remove = onCleanup(@() clear('-f', 'planArmPickAndPlace'));
  arm = struct('index', 1, 'opening', 2, 'reach', 0.75, 'palm', 0.75, 'foot', [0, 0]);
  start = block([1, 0, 0], [1, 1, 1], -2, -2, 0, 0);
  goal = block([1, 0, 0], [1, 1, 1], 2, -2, 0, 0);
  plan = @(way) planPickAndPlace(arm, start, asStep(goal), noBlocks(), struct('arms', struct('joints', [])), [], way);
  usual = plan(wayOf(choicesOf(struct()), 0));
  holds = cell2mat(arrayfun(@(move) plan(wayOf(choicesOf(struct('variationGrasp', 7)), move))', 1:20, 'UniformOutput', false));
  check(numel(unique(holds(1, :))) > 1 && all(holds(2, :) == usual(2)), 'a seed varies how a block is held');
  rises = cell2mat(arrayfun(@(move) plan(wayOf(choicesOf(struct('variationPath', 7)), move))' - usual', 1:20, ...
                            'UniformOutput', false));
  check(numel(unique(rises(2, :))) == 20 && all(rises(2, :) > 0 & rises(2, :) <= 1), 'and how high it is carried');
end
