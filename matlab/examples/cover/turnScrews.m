function actions = turnScrews(robot, aside, holder, screws, isLoosening)
% Returns the actions that take the screwdriver from its holder (1x2), turn screws (a row for each), and put it back.
%
% The last joint of the arm turns the tool about its own axis. A stroke is half a turn and a little more; then the
% tip is lifted out of the head, and the wrist turns back. Four strokes loosen a screw, five fasten it until it
% is surely tight.
  for arm = numel(robot.arms):-1:1
    for start = startAngles(robot, arm, aside)'
      actions = planFrom(robot, aside, arm, start', holder, screws, isLoosening);
      if ~isempty(actions), return, end
    end
  end
  error('no arm reaches the screwdriver and the screws');
end

function actions = planFrom(robot, aside, arm, start, holder, screws, isLoosening)
% Returns {} if it is not possible from these angles.
  inHolder = 0.2;  % heights of the tip: in the holder, in the head of a screw, above it, and on the way
  inside = 1.68;
  lifted = 2.08;
  carried = 2.1;
  strokes = 5;
  stroke = 183 * pi / 180;  % clockwise fastens
  if isLoosening
    strokes = 4;
    stroke = -stroke;
  end
  % Half a stroke to each side of the middle of the joint.
  first = (robot.minJointAngles(arm, end) + robot.maxJointAngles(arm, end)) / 2 - stroke / 2;
  actions = {};
  q = smileInverse(robot, robot.arms{arm}, tool(holder, carried), start, 'anyTurn', true, 'maxIterations', 300);
  if isempty(q), return, end
  q(end) = first;
  toHolder = move(robot, arm, aside(arm, :), q);
  [down, q] = line(robot, arm, q, tool(holder, inHolder));
  [up, q] = line(robot, arm, q, tool(holder, carried));
  qTaken = q;
  if isempty(q), return, end
  plan = [grip(arm, -1, 1.3), follow(arm, {toHolder, down}), grip(arm, -1, -Inf), follow(arm, {up})];
  for k = 1:size(screws, 1)
    screw = screws(k, :);
    [across, qEnd] = wayAcross(robot, arm, q, tool(screw, carried));
    if isempty(qEnd), return, end
    q = [qEnd(1:end - 1) first];
    adjust = move(robot, arm, qEnd, q);
    [lower, q] = line(robot, arm, q, tool(screw, lifted));
    if isempty(q), return, end
    q(end) = first;
    [insert, qIn] = line(robot, arm, q, tool(screw, inside));
    if isempty(qIn), return, end
    qTurned = [qIn(1:end - 1) qIn(end) + stroke];
    [lift, qLifted] = line(robot, arm, qTurned, tool(screw, lifted));
    if isempty(qLifted), return, end
    cycle = follow(arm, {insert, move(robot, arm, qIn, qTurned), lift, move(robot, arm, qLifted, q)});
    [leave, q] = line(robot, arm, q, tool(screw, carried));
    if isempty(q), return, end
    plan = [plan, follow(arm, {across, adjust, lower}), repmat(cycle, 1, strokes), follow(arm, {leave})];
  end
  % The screwdriver is put back as it stood, by the angles at which it was taken.
  [across, q] = wayAcross(robot, arm, q, tool(holder, carried));
  if isempty(q), return, end
  adjust = move(robot, arm, q, qTaken);
  [down, q] = line(robot, arm, qTaken, tool(holder, inHolder + 0.02));
  [up, q] = line(robot, arm, q, tool(holder, carried));
  if isempty(q), return, end
  plan = [plan, follow(arm, {across, adjust, down}), grip(arm, 1, 1.3), ...
          follow(arm, {up, move(robot, arm, q, aside(arm, :))})];
  for k = 1:numel(plan)
    isMotion = strcmp(plan{k}.kind, 'follow');
    if ~isMotion, continue, end
    if ~isempty(smileFirstInvalid(robot, plan{k}.motion, 'qBoth', aside, 'table', tableSize())), return, end
  end
  actions = plan;
end

function motion = move(robot, arm, q, goal)
% Plans a motion of the joints from angles to angles.
  motion = smileMoveJoints(robot, robot.arms{arm}, [q; goal], 'speed', 0.7);
end

function [motion, q] = wayAcross(robot, arm, q, pose)
% Plans a motion over the table: straight, or the way that is best for the joints; [] if none exists.
  from = q;
  [motion, q] = line(robot, arm, from, pose);
  if ~isempty(q) || isempty(from), return, end
  q = smileInverse(robot, robot.arms{arm}, pose, from, 'anyTurn', true, 'maxIterations', 300);
  if ~isempty(q), motion = move(robot, arm, from, q); end
end

function [motion, q] = line(robot, arm, q, pose)
% Plans a straight line, on which the tool may turn about its own axis; [] if none exists.
  motion = [];
  if isempty(q), return, end
  motion = smileMoveLine(robot, robot.arms{arm}, q, pose, 'toolSpeed', 4, 'anyTurn', true);
  if isempty(motion), q = []; else, q = motion.positions(end, :); end
end

function pose = tool(place, tip)
% Returns the pose of a tool that holds the screwdriver, its tip over a place at a height.
  gripHeight = 2;  % above the tip
  pose = poseAt([place(1:2), tip + gripHeight], [0 1 0]);
end
