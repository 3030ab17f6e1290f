function actions = planScrews(robot, aside, holder, screws, is_loosening)
% Plans to take the screwdriver from its holder (1x2), to turn screws (a row for each), and to put it back.
%
% The last joint of the arm turns the tool about its own axis. A stroke is half a turn and a little more; then the
% tip is lifted out of the head, and the wrist turns back. Four strokes loosen a screw, five fasten it until it
% is surely tight.
  for arm = [2 1]
    for start = startPostures(robot, arm, aside)'
      actions = planFrom(robot, aside, arm, start', holder, screws, is_loosening);
      if ~isempty(actions), return, end
    end
  end
  error('no arm reaches the screwdriver and the screws');
end

function actions = planFrom(robot, aside, arm, start, holder, screws, is_loosening)
% Returns {} if it is not possible from these angles.
  in_holder = 0.2; inside = 1.68; lifted = 2.08; carried = 2.1;  % heights of the tip
  stroke = 183 * pi / 180;
  if is_loosening, strokes = 4; way = -1; else, strokes = 5; way = 1; end  % clockwise fastens
  first = (robot.minJointAngles(arm, end) + robot.maxJointAngles(arm, end)) / 2 - way * stroke / 2;
  actions = {};
  q = smileInverse(robot, robot.arms{arm}, tool(holder, carried), start, 'anyTurn', true, ...
                   'maxIterations', 300);
  if isempty(q), return, end
  q(end) = first;
  plan = follow(arm, armMotion(robot, arm, aside(arm, :), q));
  [down, q] = line(robot, arm, q, tool(holder, in_holder));
  [up, q] = line(robot, arm, q, tool(holder, carried));
  q_taken = q;
  plan = [grip(arm, -1, 1.3), plan, follow(arm, down), grip(arm, -1, -Inf), follow(arm, up)];
  for screw = screws'
    [across, q_end] = wayAcross(robot, arm, q, tool(screw, carried));
    if isempty(q_end), return, end
    q = [q_end(1:end - 1) first];
    adjust = armMotion(robot, arm, q_end, q);
    [lower, q] = line(robot, arm, q, tool(screw, lifted));
    if isempty(q), return, end
    q(end) = first;
    [insert, q_in] = line(robot, arm, q, tool(screw, inside));
    if isempty(q_in), return, end
    q_turned = [q_in(1:end - 1) q_in(end) + way * stroke];
    [lift, q_lifted] = line(robot, arm, q_turned, tool(screw, lifted));
    if isempty(q_lifted), return, end
    cycle = follow(arm, insert, armMotion(robot, arm, q_in, q_turned), lift, ...
                   armMotion(robot, arm, q_lifted, q));
    [leave, q] = line(robot, arm, q, tool(screw, carried));
    if isempty(q), return, end
    plan = [plan, follow(arm, across, adjust, lower), repmat(cycle, 1, strokes), follow(arm, leave)];
  end
  % The screwdriver is put back as it stood, by the angles at which it was taken.
  [across, q] = wayAcross(robot, arm, q, tool(holder, carried));
  if isempty(q), return, end
  adjust = armMotion(robot, arm, q, q_taken);
  [down, q] = line(robot, arm, q_taken, tool(holder, in_holder + 0.02));
  [up, q] = line(robot, arm, q, tool(holder, carried));
  if isempty(q), return, end
  plan = [plan, follow(arm, across, adjust, down), grip(arm, 1, 1.3), ...
          follow(arm, up, armMotion(robot, arm, q, aside(arm, :)))];
  for k = 1:numel(plan)
    is_motion = strcmp(plan{k}.kind, 'follow');
    if ~is_motion, continue, end
    if ~isempty(smileFirstInvalid(robot, plan{k}.motion, 'qBoth', aside, 'table', [20 12])), return, end
  end
  actions = plan;
end

function [motion, q] = wayAcross(robot, arm, q, pose)
% Plans a motion over the table: straight, or the way that is best for the joints; [] if there is none.
  from = q;
  [motion, q] = line(robot, arm, from, pose);
  if ~isempty(q) || isempty(from), return, end
  q = smileInverse(robot, robot.arms{arm}, pose, from, 'anyTurn', true, 'maxIterations', 300);
  if ~isempty(q), motion = armMotion(robot, arm, from, q); end
end

function [motion, q] = line(robot, arm, q, pose)
% Plans a straight line, on which the tool may turn about its own axis; [] if there is none.
  motion = [];
  if isempty(q), return, end
  motion = smileMoveLine(robot, robot.arms{arm}, q, pose, 'toolSpeed', 4, 'anyTurn', true);
  if isempty(motion), q = []; else, q = motion.positions(end, :); end
end

function pose = tool(place, tip)
% Returns the pose of a tool that holds the screwdriver, its tip over a place at a height.
  grip_height = 2;  % above the tip
  pose = poseAt(place, tip + grip_height, [0 1 0]);
end
