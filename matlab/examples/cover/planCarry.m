function actions = planCarry(robot, aside, start, start_height, goal, goal_height, over)
% Plans to carry an object from a place to another one, and to set it down parallel to it. The fingers are at its
% longer sides; it may be grasped, and stand, in two ways. A straight way keeps it level on its way across.
  for across = {'line', 'joints'}
    for sides = [1 1 -1 -1; 1 -1 1 -1]
      poses = {poseAt(start.middle, over, sides(1) * start.y), ...
               poseAt(start.middle, start_height, sides(1) * start.y), ...
               poseAt(goal.middle, over, sides(2) * goal.y), ...
               poseAt(goal.middle, goal_height + 0.02, sides(2) * goal.y)};
      poses = poses([1 2 1 3 4 3]);
      ways = {'joints', 'line', 'line', across{1}, 'line', 'line'};
      for arm = nearestFirst(robot, aside, poses{1})
        motions = planPath(robot, aside, arm, ways, poses);
        if ~isempty(motions)
          wide = 0.9;  % opening around an object of 0.4
          actions = [grip(arm, -1, wide), follow(arm, motions{1:2}), grip(arm, -1, -Inf), ...
                     follow(arm, motions{3:5}), grip(arm, 1, wide), follow(arm, motions{6:7})];
          return
        end
      end
    end
  end
  error('no arm can carry it');
end

function arms = nearestFirst(robot, aside, pose)
  distance = zeros(1, 2);
  for arm = 1:2
    tool = smileForward(robot, robot.arms{arm}, aside(arm, :));
    distance(arm) = norm(tool(1:3, 4) - pose(1:3, 4));
  end
  [~, arms] = sort(distance);
end

function motions = planPath(robot, aside, arm, ways, poses)
% Plans motions of an arm through poses and back aside; {} if it cannot do all of them.
  name = robot.arms{arm};
  for start = startPostures(robot, arm, aside)'
    motions = {};
    q = aside(arm, :);
    for k = 1:numel(poses)
      motion = [];
      if strcmp(ways{k}, 'line')
        motion = smileMoveLine(robot, name, q, poses{k}, 'toolSpeed', 4);
      else
        if k == 1, from = start'; else, from = q; end
        goal = smileInverse(robot, name, poses{k}, from, 'maxIterations', 300);
        if ~isempty(goal), motion = armMotion(robot, arm, q, goal); end
      end
      if isempty(motion) || ~isempty(smileFirstInvalid(robot, motion, 'qBoth', aside, 'table', [20 12]))
        motions = {};
        break
      end
      motions{end + 1} = motion;
      q = motion.positions(end, :);
    end
    if ~isempty(motions)
      motions{end + 1} = armMotion(robot, arm, q, aside(arm, :));
      return
    end
  end
end
