function [arm, motions] = planPath(robot, aside, path)
% Plans motions through the poses of a path, from the angles `aside` of an arm: first for the arm whose hand is nearest.
%
%   path     Kx2 cell: 'line' or 'joints', and the pose to which the tool then moves
%   arm      number of the arm; [] if no arm can follow the path
%   motions  1xK cell
  distances = zeros(1, numel(robot.arms));
  for k = 1:numel(robot.arms)
    hand = smileForward(robot, robot.arms{k}, aside(k, :));
    distances(k) = norm(path{1, 2}(1:3, 4) - hand(1:3, 4));
  end
  [~, order] = sort(distances);
  for arm = order
    starts = startAngles(robot, arm, aside);
    for row = 1:size(starts, 1)
      motions = planFrom(robot, arm, aside, starts(row, :), path);
      if numel(motions) == size(path, 1), return, end
    end
  end
  arm = [];
  motions = {};
end

function motions = planFrom(robot, arm, aside, start, path)
  name = robot.arms{arm};
  q = aside(arm, :);
  motions = {};
  for k = 1:size(path, 1)
    if strcmp(path{k, 1}, 'line')
      motion = smileMoveLine(robot, name, q, path{k, 2}, 'toolSpeed', 4);
    else
      goal = smileInverse(robot, name, path{k, 2}, start, 'maxIterations', 300);
      if isempty(goal), return, end
      motion = smileMoveJoints(robot, name, [q; goal], 'speed', 0.7);
    end
    if isempty(motion) || ~isempty(smileFirstInvalid(robot, motion, 'qBoth', aside, 'table', tableSize()))
      return
    end
    motions{end + 1} = motion;
    q = motion.positions(end, :);
    start = q;
  end
end
