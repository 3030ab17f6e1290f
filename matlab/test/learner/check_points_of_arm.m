function check_points_of_arm()
% Its first two joints turn about vertical axes through x = 0 and x = q(4), the third one slides, and the fourth one turns about an axis along
% x, at y = 0 and z = 3.
  eval('function poses = smileForward(~, ~, q), poses = repmat(eye(4), 1, 1, rows(q)); poses(1:3, 4, :) = q(:, 1:3).''; end');
  eval(['function jacobians = smileJacobian(~, ~, q), at = @(q) [-q(2), -q(2), 0, 0; q(1), q(1) - q(4), 0, 3 - q(3); 0, 0, 1, q(2);', ...
        '0, 0, 0, 1; 0, 0, 0, 0; 1, 1, 0, 0]; all = cellfun(at, num2cell(q, 2), ''UniformOutput'', false);', ...
        'jacobians = cat(3, all{:}); end']);
  remove = onCleanup(@() clear('-f', 'smileForward', 'smileJacobian'));
  arm = struct('robot', [], 'name', '');
  q = [3, 0.2, 2.9, 2; 5, -1, 1, 4; 2, 0, 3, 1];
  points = armPoints(arm, q);
  for k = 1:3
    expected = [q(k, 1:3); q(k, 1), 0, 3; q(k, 4), 0, 3; 0, 0, 3];
    check(max(max(abs(points(:, :, k) - expected))) < 1e-12, 'points of an arm are on the axes of its joints');
  end
  apart = arrayfun(@(k) pointsFromWrist(arm, q(k, :)), 1:3, 'UniformOutput', false);
  check(isequal(pointsFromWrist(arm, q), vertcat(apart{:})), 'those of several postures follow one another');
  n = constants().motion_planning.points_per_link;
  check(isequal(cellfun(@rows, apart), n * [1, 2, 1]), 'what is close to the tool is not behind the wrist');
end
