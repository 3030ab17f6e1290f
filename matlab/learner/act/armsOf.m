function arms = armsOf(aux)
% Returns the arms of a brain's robot, a 1xN struct array:
%   robot     from smileRobot
%   name      for the functions of smileRobot
%   index     among the arms of the robot, from 1
%   camera    of its hand; '' if it has none
%   opening   largest opening of its gripper [units]; 0 without a gripper
%   ready     1xn joint angles [rad]: its hand over the table, fingers straight down
%   lower, upper  limits of its joints, 1xn [rad]
%   foot      x y of its first joint [units]
%   hasTorso  true beside other arms
%   parked    1xn joint angles: where it waits
%   allParked joint angles of all arms, as smileFirstInvalid takes them
%   starts    Mxn joint angles from which to search for others
%   reach     of the fingers below the tool, when they point straight down [units]
%   palm      how far above the tool the fingers begin then [units]; Inf if that is unknown
  robot = smileRobot(aux);
  eye = eyeOfRobot(aux);
  arms = struct('robot', {}, 'name', {}, 'index', {}, 'camera', {}, 'opening', {}, 'ready', {}, 'lower', {}, 'upper', {});
  counts = arrayfun(@(arm) numel(arm.joints), aux.arms);
  for k = 1:numel(aux.arms)
    ready = namedPose(robot, counts, k, 'ready');
    if isempty(ready), error('the robot has no pose "ready": smile robots add makes one'); end
    camera = [aux.arms(k).name, '_hand'];
    if ~any(strcmp(aux.cameraNames, camera)), camera = ''; end
    arms(k) = struct('robot', robot, 'name', aux.arms(k).name, 'index', k, 'camera', camera, ...
                     'opening', max([0, aux.arms(k).gripper(:)']), 'ready', ready, ...
                     'lower', ofArm(robot.minJointAngles, counts, k), ...
                     'upper', ofArm(robot.maxJointAngles, counts, k));
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
    arms(k).palm = palmOf(arms(k));
  end
  if size(robot.minJointAngles, 1) > 1
    all_parked = vertcat(arms.parked);
  else
    all_parked = [arms.parked];
  end
  for k = 1:numel(arms), arms(k).allParked = all_parked; end
end

function palm = palmOf(arm)
% Returns how far above the tool of an arm the fingers begin when they point straight down [units]; Inf if they are unknown.
  palm = Inf;
  try
    palm = -smileFingerBounds(arm.robot, arm.name, 0)(1, 3);
  catch  % no gripper, or one without shapes that move
  end
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
