% Asks what agreement.cc asks, in Octave: octave-cli agreement.m URDF, with the folders on the path.
1;

function show(name, numbers)
  text = '';
  if ~isempty(numbers), text = sprintf(' %.17g', numbers); end
  printf('%s%s\n', name, text);
end

function show_rows(name, matrix)
  for i = 1:rows(matrix), show(name, matrix(i, :)); end
end

function show_move(name, move)
  for k = 1:numel(move.times)
    show([name ' times'], move.times(k));
    show([name ' positions'], move.positions(k, :));
    show([name ' velocities'], move.velocities(k, :));
  end
  [q, v] = smileSample(move, move.duration / 3);
  show([name ' sample'], q');  % row by row
  show([name ' sample'], v');
end

function q = configuration(robot, arm, k)
  arms = struct('left', 1, 'right', 2, 'both', 1:2).(arm);
  lower = robot.minJointAngles(arms, :);
  upper = robot.maxJointAngles(arms, :);
  share = reshape(mod(k * 37 + (0:numel(lower) - 1) * 61, 101) / 101, 7, [])';
  q = lower + share .* (upper - lower);
end

function query_arm(robot, arm)
  ready = robot.poses.untucked(struct('left', 1, 'right', 2).(arm), :);
  show_rows('fingers', smileFingerBounds(robot, arm, 0.4));
  for k = 0:39
    goal = smileForward(robot, arm, configuration(robot, arm, k));
    show_rows('forward', goal);
    show_rows('jacobian', smileJacobian(robot, arm, configuration(robot, arm, k)));
    for anyTurn = [false, true]
      show('inverse', smileInverse(robot, arm, goal, ready, 'anyTurn', anyTurn));
    end
  end
  waypoints = zeros(5, 7);
  for k = 1:5, waypoints(k, :) = configuration(robot, arm, k - 1); end
  show_move('through', smileMoveJoints(robot, arm, waypoints, 'speed', 0.5));
  straight = smileMoveJoints(robot, arm, waypoints(1:2, :));
  show_move('straight', straight);
  moment = smileFirstInvalid(robot, straight, 'held', [-3, -3, -0.5; 3, 3, 0.5]);
  if ~isempty(moment), show(['held ' moment.reason], moment.seconds); end

  for way = [1, 40]
    goal = smileForward(robot, arm, ready);
    goal(3, 4) += way;
    [move, fault] = smileMoveLine(robot, arm, ready, goal, 'toolSpeed', 2);
    if isempty(move), show(['fault ' fault.reason], fault.fraction); else, show_move('line', move); end
  end
end

function query_both(robot)
  low = configuration(robot, 'both', 3);
  high = configuration(robot, 'both', 8);
  move = smileMoveJoints(robot, 'both', cat(3, low, high, low));
  show_move('both', move);
  moment = smileFirstInvalid(robot, move, 'qBoth', low, 'table', [20 12]);
  if ~isempty(moment), show(['invalid ' moment.reason], moment.seconds); end
end

robot = smileRobot(argv(){end}, [0 -1 0 0.5; 1 0 0 -8; 0 0 1 2; 0 0 0 1], 0.1);
query_arm(robot, 'left');
query_arm(robot, 'right');
query_both(robot);
