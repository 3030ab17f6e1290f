function check_pushes()
% The place of a block is in the corner of two others, to its left and below it as seen from above.
  cube = [1, 1, 1];
  corner = [block([1, 0, 0], cube, 0, -2, 0, 0), block([0, 1, 0], cube, 1, -3, 0, 0)];
  goal = block([0, 0, 1], cube, 1, -2, 0, 0);
  ways = pushWays(goal, goal, corner);
  check(isempty(graspYaws(goal, corner)) && isNear(vertcat(ways.away), [1, 0; 0, 1]), 'ways lead away from what a block touches');
  taken = pushWays(goal, goal, [corner, block([1, 0, 0], cube, 1, -0.6, 0, 0)]);
  check(isNear(vertcat(taken.away), [1, 0]), 'whose starts are free');

  upper = goal;
  upper.position(3) = 1.5;
  beside = corner;
  for k = 1:2, beside(k).position(3) = 1.5; end
  below = [block([1, 0, 0], cube, 1, -2.1, 0, 0), block([1, 0, 0], cube, 2, -2, 0, 0)];
  carried = pushWays(upper, upper, [corner, beside, below]);
  check(isNear(vertcat(carried.away), [1, 0]), 'a block on others does not fall where its way begins');

  moved = @(shift, turn) setfield(setfield(ways(1).start, 'position', ways(1).start.position + shift), 'yaw', turn);
  check(isOnWay(moved([0, 0, 0], 0), ways(1)), 'a block is pushed from where its way begins');
  check(isOnWay(moved([-0.2, 0.03, 0], pi / 2), ways(1)), 'or from closer');
  for it = {[0.1, 0, 0], [0, 0.05, 0], [-0.5, 0, 0], [0, 0, 1]}
    check(~isOnWay(moved(it{1}, 0), ways(1)), sprintf('but not if it is off by %g %g %g', it{1}));
  end
  check(~isOnWay(moved([0, 0, 0], 0.1), ways(1)), 'or turned');
  check_in_way(corner, goal);
  check_hidden_tops();
end

function check_in_way(corner, goal)
% A hand needs room behind the start of a way.
  eval('function yes = isReachable(varargin), yes = true; end');
  eval('function q = solvePoses(varargin), q = 0; end');
  eval(['function hands = pushingHands(arm, block, way, others), at = block.position(1:2) + 1.2 * way.away;', ...
        'hands = struct("poses", {{eye(4)}}); if any(vecnorm(vertcat(others.position)(:, 1:2) - at, 2, 2) < 0.5), hands = []; end; end']);
  arm = struct('reach', 0.75, 'palm', 0.75, 'parked', 0, 'foot', [1, -5], 'robot', [], 'name', '');
  eval('function bounds = smileFingerBounds(varargin), bounds = [0, 0, 0; 0.4, 0.3, 0]; end');
  remove = onCleanup(@() clear('-f', 'isReachable', 'solvePoses', 'pushingHands', 'smileFingerBounds'));
  movesWith = @(free, blocks) movesFromPush(struct('known', blocks, 'containers', []), goal, free, arm);
  behind = [block([1, 0, 0], [1, 1, 1], 2.7, -2, 0, 0), block([0, 0, 1], [1, 1, 1], 1, -0.3, 0, 0)];
  far = block([0, 0, 1], [1, 1, 1], -5, -2, 0, 0);
  check(isempty(movesWith(3:4, [corner, behind(1), far])), 'what is behind one way is not in the way of the other');
  check(isempty(movesWith(3:5, [corner, behind, far])), 'nor what can be pushed itself');
  behind(2).color = [1, 0, 0];
  moves = movesWith(3:5, [corner, behind, far]);
  check(isequal([moves.block], 3:4), 'what is where a hand pushes goes elsewhere');
  room = [moves.room];
  check(isNear(vertcat(room.position)(:, 1:2), [1.7, -2; 1, -1.3]), 'but not to where the block is pushed from, and the hand is behind it');
  check(isempty(movesWith(3:4, [corner, behind])), 'where there is nothing to push nothing goes elsewhere');
  check(isempty(movesWith(2:4, [corner(1), behind, far])), 'nor where fingers have room');
end

function check_hidden_tops()
  known = [block([1, 0, 0], [2, 1, 1], 0, -2, 0, 0), block([1, 0, 0], [2, 1, 1], 0, -3, 0, 0)];
  seen = block([1, 0, 0], [2, 1, 1], -0.5, -2.5, 0, pi / 2);
  beside = block([1, 0, 0], [2, 1, 1], -0.8, -2.5, 0, pi / 2);
  hidden = struct('word', 'hidden', 'expected', {known(1), known(2)}, 'found', []);
  check(isequal(corrected(noBlocks(), hidden), known), 'what is hidden is known, also if nothing is seen');
  check(isequal(corrected(seen, hidden), known), 'tops of hidden blocks do not make another one');
  check(isequal(corrected(beside, hidden), [beside, known]), 'but what is beside them is one');
  recognized = struct('word', 'as expected', 'expected', seen, 'found', 1);
  check(isequal(corrected(seen, [hidden, recognized]), [seen, known]), 'and what was known to be there');
end

function yes = isNear(some, others)
  yes = isequal(size(some), size(others)) && all(abs(some(:) - others(:)) < 1e-9);
end
