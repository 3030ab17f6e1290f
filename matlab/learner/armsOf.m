function arms = armsOf(aux)
% Returns the arms of a brain's robot, a 1xN struct array:
%   robot     from smileRobot
%   name      for the functions of smileRobot
%   index     among the arms of the robot, from 1
%   opening   largest opening of its gripper [units]; 0 without a gripper
%   ready     1xn joint angles [rad]: its hand over the table, fingers straight down
%   lower, upper  limits of its first joint [rad]
%   foot      x y of its first joint [units]
%   hasTorso  true beside other arms
%   parked    1xn joint angles: where it waits
%   allParked joint angles of all arms, as smileFirstInvalid takes them
%   starts    Mxn joint angles from which to search for others
%   reach     of the fingers below the tool, when they point straight down [units]
  robot = smileRobot(aux);
  eye = struct('intrinsics', aux.cameraIntrinsics, 'pose', aux.cameraPose);
  arms = struct('robot', {}, 'name', {}, 'index', {}, 'opening', {}, 'ready', {}, 'lower', {}, 'upper', {});
  counts = arrayfun(@(arm) numel(arm.joints), aux.arms);
  for k = 1:numel(aux.arms)
    ready = namedPose(robot, counts, k, 'ready');
    if isempty(ready), error('the robot has no pose "ready": smile robots add makes one'); end
    lower = ofArm(robot.minJointAngles, counts, k);
    upper = ofArm(robot.maxJointAngles, counts, k);
    arms(k) = struct('robot', robot, 'name', aux.arms(k).name, 'index', k, ...
                     'opening', max([0, aux.arms(k).gripper(:)']), 'ready', ready, ...
                     'lower', lower(1), 'upper', upper(1));
  end
  for k = 1:numel(arms)
    points = armPoints(arms(k), arms(k).ready);
    arms(k).foot = points(end, 1:2);
    arms(k).hasTorso = numel(arms) > 1;
  end
  feet = vertcat(arms.foot);
  for k = 1:numel(arms)
    arms(k).parked = namedPose(robot, counts, k, 'parked');
    if isempty(arms(k).parked)
      arms(k).parked = postureAside(arms(k), eye, feet(k, 1) <= mean(feet(:, 1)));
    end
    arms(k).starts = [arms(k).parked; arms(k).ready; namedPose(robot, counts, k, 'neutral')];
    arms(k).reach = fingerReach(arms(k));
  end
  if size(robot.minJointAngles, 1) > 1
    all_parked = vertcat(arms.parked);
  else
    all_parked = [arms.parked];
  end
  for k = 1:numel(arms), arms(k).allParked = all_parked; end
end

function q = namedPose(robot, counts, k, name)
% Returns the joint angles of arm k in a named pose of the robot, 1xn; [] if it has no such pose.
  q = [];
  if isfield(robot.poses, name), q = ofArm(robot.poses.(name), counts, k); end
end

function q = ofArm(values, counts, k)
% Returns the values of arm k, 1xn. Arms with different numbers of joints are in one row.
%   counts  numbers of joints of the arms
  if size(values, 1) == numel(counts)
    q = values(k, :);
  else
    q = values(sum(counts(1:k - 1)) + (1:counts(k)));
  end
end

function reach = fingerReach(arm)
% Returns how far the fingers reach below the tool when they point straight down: the height of the tool
% at which they touch the table, found by bisection.
  accuracy = constants().arms.reach_accuracy;
  tool = smileForward(arm.robot, arm.name, arm.ready);
  over = tool(1:3, 4)';
  touching = 0;
  free = over(3);
  while free - touching > accuracy / 4
    height = (touching + free) / 2;
    q = armInverse(arm, toolPose(arm, [over(1:2), height], 0, 0), arm.ready, 'anyTurn', true);
    if ~isempty(q) && isValidAt(arm, q), free = height; else, touching = height; end
  end
  reach = round(free / accuracy) * accuracy;
end

function best = postureAside(arm, eye, is_left)
% Returns joint angles of an arm beside the table: its hand as high as possible, its first joint turned
% until the eye sees least of it, outward beside other arms.
  c = constants().arms;
  q_high = raisedPosture(arm);
  best = q_high;
  lowest = [Inf, Inf, Inf];
  for angle = arm.lower * c.parked_limit:c.parked_turn_rad:arm.upper * c.parked_limit + c.parked_turn_rad / 2
    q = [angle, q_high(2:end)];
    is_outward = (angle > q_high(1)) == is_left;
    if ~isValidAt(arm, q) || (arm.hasTorso && ~is_outward), continue; end
    cost = [visibleExtent(armPoints(arm, q), eye), ~is_outward, abs(angle - q_high(1))];
    better = find(cost ~= lowest, 1);
    if ~isempty(better) && cost(better) < lowest(better)
      lowest = cost;
      best = q;
    end
  end
end

function q = raisedPosture(arm)
% Returns joint angles with the tool above the place of the pose `ready`, or closer to the robot, as high
% as possible.
  c = constants().arms;
  tool = smileForward(arm.robot, arm.name, arm.ready);
  over = tool(1:2, 4)';
  for height = c.parked_heights(1):c.parked_heights(2):c.parked_heights(3)
    for fraction = c.parked_distances'
      place = arm.foot + fraction * (over - arm.foot);
      q = armInverse(arm, toolPose(arm, [place, height], 0, 0), arm.ready, 'anyTurn', true);
      if ~isempty(q) && isValidAt(arm, q), return; end
    end
  end
  q = arm.ready;
end

function yes = isValidAt(arm, q)
% Returns true if the arm touches neither the robot nor the table.
  still = smileMoveJoints(arm.robot, arm.name, q);
  yes = isempty(smileFirstInvalid(arm.robot, still, 'table', constants().arms.table'));
end

function extent = visibleExtent(points, eye)
% Returns how much of the lines between points is in the eye's picture: the sum of the distances of points
% on them from its border [pixels]. Beyond the border, thick links may still be visible.
  c = constants().arms;
  size_px = 2 * eye.intrinsics(1:2, 3)';
  margin = c.parked_margin * size_px;
  extent = 0;
  for k = 1:size(points, 1) - 1
    for fraction = linspace(0, 1, c.points_per_link)
      at = points(k, :) + fraction * (points(k + 1, :) - points(k, :));
      if (at - eye.pose(1:3, 4)') * eye.pose(1:3, 3) > 0  % in front of the eye
        pixel = toPixel(at, eye);
        extent = extent + max(0, min([pixel + margin, size_px + margin - pixel]));
      end
    end
  end
  extent = round(extent);
end
