function check_path_over()
% A hand moves along x; its fingers, which point down, reach 0.7 below its tool, and its bar 1.3 to both sides, along y.
  eval('function q = samplesOf(path), q = linspace(-4, 4, 41)''; end');
  eval('function pose = smileForward(robot, name, q), pose = [-1, 0, 0, q; 0, 1, 0, robot(2); 0, 0, -1, robot(1); 0, 0, 0, 1]; end');
  eval('function points = armPoints(arm, q), points = [q, arm.robot(2), arm.robot(1)] + [0, 0, 0; 0, 0, 5]; end');
  remove = onCleanup(@() clear('-f', 'samplesOf', 'smileForward', 'armPoints'));
  tower = block([1, 0, 0], [1, 1, 1], 0.5, 0, 2, 0);
  is_over = @(height, y, blocks) isPathOver(struct('reach', 0.7, 'name', 'arm', 'robot', [height, y]), [], blocks);
  check(is_over(3.9, 0, tower), 'it passes over blocks');
  check(~is_over(3.7, 0, tower), 'with its fingers, too');
  check(~is_over(3.7, 2, tower), 'and with the end of its bar');
  check(is_over(3.7, 3, tower), 'or beside them');
  check(is_over(3.7, 0, noBlocks()), 'also where there are none');
end
