% Tests what is Octave's own in matlab/motion, without the simulator; its folder and the one of
% smilemotion.mex must be on the path:
%
%   octave-cli --path build/dev/matlab --path matlab/motion matlab/test/motion_test.m URDF
%
% prints "ok", or what is wrong, and exits with 0 or 1.
1;

function check(is_true, claim)
  if ~is_true, error('not so: %s', claim); end
end

function expect_error(message, call)
  try
    call();
  catch err
    check(strcmp(err.message, message), sprintf('"%s" is "%s"', err.message, message));
    return
  end
  error('not so: there is an error "%s"', message);
end

function check_answers(robot)
  q = robot.poses.untucked(1, :);
  goal = smileForward(robot, 'left', q + 0.2);
  found = smileInverse(robot, 'left', goal, q);
  check(isequal(size(found), [1 7]), 'q is a row');
  check(norm(smileForward(robot, 'left', found) - goal) < 5e-6, 'inverse undoes forward');
  rows = [q; found; q + 0.1];
  poses = smileForward(robot, 'left', rows);
  jacobians = smileJacobian(robot, 'left', rows);
  check(isequal(size(poses), [4, 4, 3]) && isequal(size(jacobians), [6, 7, 3]), 'several rows give several matrices');
  check(isequal(poses(:, :, 2), smileForward(robot, 'left', found)), 'each pose as alone');
  check(isequal(jacobians(:, :, 3), smileJacobian(robot, 'left', rows(3, :))), 'and each Jacobian');

  goals = cat(3, goal, smileForward(robot, 'left', q - 0.2));
  both = smileInverse(robot, 'left', goals, q);
  check(isequal(both, [found; smileInverse(robot, 'left', goals(:, :, 2), found)]), 'of several goals, each from the one before');

  goal(1, 4) = 40;
  check(isempty(smileInverse(robot, 'left', goal, q)), 'an unreachable goal is []');
  check(isempty(smileInverse(robot, 'left', cat(3, goals, goal), q)), 'also after others');
  [move, fault] = smileMoveLine(robot, 'left', q, goal);
  check(isempty(move) && fault.fraction < 1, 'a line out of reach has a fault');
  check(~isempty(fault.reason), 'and a reason');

  move = smileMoveJoints(robot, 'both', cat(3, robot.poses.untucked, robot.poses.neutral));
  [last, velocities] = smileSample(move, move.duration);
  check(isequal(last, robot.poses.neutral), 'a motion of both arms ends at its last waypoint');
  check(isequal(velocities, zeros(2, 7)), 'at rest');
  times = move.duration * [0, 0.3, 1];
  [all, velocities] = smileSample(move, times);
  check(isequal(size(all), [2, 7, 3]), 'several times are waypoints of both arms');
  [q, velocity] = smileSample(move, times(2));
  check(isequal(all(:, :, 2), q) && isequal(velocities(:, :, 2), velocity), 'each as alone');
  move = smileMoveJoints(robot, 'left', [robot.poses.untucked(1, :); robot.poses.neutral(1, :)]);
  all = smileSample(move, times);
  check(isequal(size(all), [3, 7]) && isequal(all(2, :), smileSample(move, times(2))), 'or of one arm');
end

function check_errors(robot)
  q = zeros(1, 7);
  expect_error('smileForward: q is 1x6, expected Nx7', @() smileForward(robot, 'left', zeros(1, 6)));
  expect_error('smileForward: q is 7x1, expected Nx7', @() smileForward(robot, 'left', zeros(7, 1)));
  expect_error('smileForward: q is not finite', @() smileForward(robot, 'left', nan(1, 7)));
  expect_error('smileForward: q: expected real numbers (double)', ...
               @() smileForward(robot, 'left', int8(q)));
  expect_error('smileForward: arm is "middle", expected left or right', ...
               @() smileForward(robot, 'middle', q));
  expect_error('smileForward: arm: expected text', @() smileForward(robot, 1, q));
  expect_error('smileForward: robot: expected what smileRobot made', ...
               @() smileForward(q, 'left', q));
  expect_error('smileInverse: goal is 3x3, expected 4x4 or 4x4xN', ...
               @() smileInverse(robot, 'left', eye(3), q));
  expect_error(['smileInverse: there is no option ''anyturn'', expected anyTurn, ' ...
                'anyRotation, positionTolerance, angleTolerance, maxIterations or seed'], ...
               @() smileInverse(robot, 'left', eye(4), q, 'anyturn', true));
  expect_error('smileMoveJoints: waypoints is 7x3, expected Kx7', ...
               @() smileMoveJoints(robot, 'left', zeros(7, 3)));
  expect_error('smileMoveLine: speed is 2, expected above 0, at most 1', ...
               @() smileMoveLine(robot, 'left', q, smileForward(robot, 'left', q), 'speed', 2));
  expect_error('smileSample: trajectory: expected what smileMoveJoints or smileMoveLine made', ...
               @() smileSample([], 1));
  expect_error('smileRobot: aux has no field robot', @() smileRobot(struct()));
end

% Nothing that is put in any place makes Octave itself fall over.
function check_nonsense(robot)
  move = smileMoveJoints(robot, 'left', [zeros(1, 7); ones(1, 7) * 0.3]);
  good = {robot, 'left', zeros(1, 7), eye(4), move, 0.5, [zeros(1, 7); ones(1, 7) * 0.3]};
  bad = {[], '', {}, struct(), NaN, Inf, -1, 1e300, 1i, true, int32(5), sparse(eye(3)), 'x', ...
         zeros(0, 7), zeros(2, 7, 3), {1, 'a'}, @sin, struct('a', {1, 2}), rmfield(move, 'times'), ...
         setfield(move, 'positions', 1), setfield(robot, 'unit', 'x'), ...
         setfield(robot, 'file', '/no/such'), setfield(move, 'numRows', 3), ['ab'; 'cd'], single(1)};
  calls = {{'smileForward', 1, 2, 3}, {'smileJacobian', 1, 2, 3}, {'smileGripperMiddle', 1, 2, 6}, {'smileFingerBounds', 1, 2, 6}, {'smileInverse', 1, 2, 4, 3}, ...
           {'smileMoveJoints', 1, 2, 7}, {'smileMoveLine', 1, 2, 3, 4}, {'smileSample', 5, 6}, ...
           {'smileFirstInvalid', 1, 5}, {'smileRobot', 2, 4, 6}, {'nonsense', 1}};
  num_errors = 0;
  for call = calls
    name = call{1}{1};
    arguments = good([call{1}{2:end}]);
    for place = 1:numel(arguments)
      for k = 1:numel(bad)
        spoilt = arguments;
        spoilt{place} = bad{k};
        try
          smilemotion(name, spoilt{:});
        catch err
          num_errors = num_errors + 1;
          check(strncmp(err.message, [name ': '], numel(name) + 2), ...
                sprintf('"%s" names %s', err.message, name));
        end
      end
      try
        smilemotion(name, arguments{1:place - 1});
      catch
        num_errors = num_errors + 1;
      end
    end
  end
  check(num_errors > 300, 'nonsense is refused');
end

try
  base = [0 -1 0 0; 1 0 0 -8; 0 0 1 2; 0 0 0 1];
  robot = smileRobot(struct('robot', argv(){end}, 'robotBase', base, 'unit', 0.1));
  check_answers(robot);
  check_errors(robot);
  check_nonsense(robot);
  disp('ok');
catch err
  disp(err.message);
  exit(1);
end
