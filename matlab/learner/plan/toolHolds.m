function holds = toolHolds(arms, tool, others, failures)
% Returns how arms may hold a tool, in the order in which they are tried, a 1xN struct array:
%   arm    one of them
%   grasp  see newGrasp
%   grip   where: distance from its middle, along it [units]
%   poses  of the arm's tool when it takes it: above, at it, and above again, 1x3 cell
%   first  joint angles from which those at the first pose are searched, 1xn [rad]
% others: blocks around it; failures: grasps that are not to be repeated
  c = constants().uses;
  holds = struct('arm', {}, 'grasp', {}, 'grip', {}, 'poses', {}, 'first', {});
  for arm = arms
    for across = graspYaws(tool, others)
      grasp = newGrasp(tool.position, arm, across);
      if hasFailed(grasp, failures), continue; end
      for grip = c.grips'
        start = heldToolPose(arm, tool, across, grip, tool.position, 0);
        for lift = c.lifts'
          above = atHeight(start, start(3, 4) + lift);
          for first = arm.starts'
            holds(end + 1) = struct('arm', arm, 'grasp', grasp, 'grip', grip, 'poses', {{above, start, above}}, 'first', first');
          end
        end
      end
    end
  end
end
