function check_path_over()
% A hand moves along x; its fingers, which point down, reach 0.7 below its tool, and its bar 1.3 to both sides, along y.
  eval('function q = samplesOf(path), q = linspace(-4, 4, 41)''; end');
  eval(['function poses = smileForward(robot, name, q), poses = repmat([-1, 0, 0, 0; 0, 1, 0, robot(2); 0, 0, -1, robot(1); 0, 0, 0, 1], 1, 1, rows(q));', ...
        'poses(1, 4, :) = q; end']);
  eval('function points = armPoints(arm, q), points = permute([q, repmat(arm.robot([2, 1]), rows(q), 1)], [3, 2, 1]) + [0, 0, 0; 0, 0, 5]; end');
  remove = onCleanup(@() clear('-f', 'samplesOf', 'smileForward', 'armPoints'));
  tower = block([1, 0, 0], [1, 1, 1], 0.5, 0, 2, 0);
  is_over = @(height, y, blocks) isPathOver(struct('reach', 0.7, 'name', 'arm', 'robot', [height, y]), [], blocks);
  check(is_over(3.9, 0, tower), 'it passes over blocks');
  check(~is_over(3.7, 0, tower), 'with its fingers, too');
  check(~is_over(3.7, 2, tower), 'and with the end of its bar');
  check(is_over(3.7, 3, tower), 'or beside them');
  check(is_over(3.7, 0, noBlocks()), 'also where there are none');
  check_way_back();
end

function check_way_back()
% Its joint is the height of its tool. What it placed is only passed over higher than 3.9.
  eval('function q = solvePoses(varargin), q = 3; end');
  eval('function path = moveJoints(arm, points), path.positions = points; end');
  eval('function path = moveLine(arm, before, goal), path.positions = [before.positions(end); goal(3, 4)]; end');
  eval('function yes = isArmClear(varargin), yes = true; end');
  eval('function yes = isPathValid(varargin), yes = true; end');
  eval('function yes = isPathOver(arm, path, blocks), yes = isempty(blocks) || max(path.positions) > 3.9; end');
  eval('function pose = smileForward(robot, name, q), pose = atHeight(eye(4), q); end');
  remove = onCleanup(@() clear('-f', 'solvePoses', 'moveJoints', 'moveLine', 'isArmClear', 'isPathValid', ...
                               'isPathOver', 'smileForward'));
  arm = struct('starts', 0, 'parked', 0, 'robot', [], 'name', 'arm');
  poses = {atHeight(eye(4), 3), atHeight(eye(4), 1), atHeight(eye(4), 3)};
  path = planPathThrough(arm, poses, noBlocks(), 0);
  check(isequal(path{end}.positions, [3; 0]), 'it goes straight back');
  path = planPathThrough(arm, poses, noBlocks(), 0, block([1, 0, 0], [1, 1, 1], 0, -2, 0, 0));
  check(numel(path) == 4 && isequal(path{end}.positions, [3; 4; 0]), 'raised first over what it placed, if necessary');
  taken = block([1, 0, 0], [1, 1, 1], 0, -2, 0, 0);
  check(isempty(planPathThrough(arm, poses, noBlocks(), 0, noBlocks(), taken)), 'nor may it strike what it takes');
end
