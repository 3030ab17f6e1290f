function holds = toolHolds(arms, tool, others, failures)
% Returns how arms may hold a tool, in the order in which they are tried, a 1xN struct array:
%   arm    one of them
%   grasp  see newGrasp
%   grip   where: distance from its middle, along it [units]
%   poses  of the arm's tool when it takes it: above, at it, and above again, 1x3 cell
%   above  joint angles at the first pose, 1xn [rad]
% others: blocks around it; failures: grasps that are not to be repeated
  c = constants().uses;
  holds = struct('arm', {}, 'grasp', {}, 'grip', {}, 'poses', {}, 'above', {});
  for arm = arms
    for across = graspYaws(tool, others)
      grasp = newGrasp(tool.position, arm, across);
      if hasFailed(grasp, failures), continue; end
      for grip = c.grips'
        start = heldToolPose(arm, tool, across, grip, tool.position, 0);
        for lift = c.lifts'
          above = atHeight(start, start(3, 4) + lift);
          poses = {above, start, above};
          for posture = posturesAt(arm, poses)'
            holds(end + 1) = struct('arm', arm, 'grasp', grasp, 'grip', grip, 'poses', {poses}, 'above', posture');
          end
        end
      end
    end
  end
end

function found = posturesAt(arm, poses)
% Returns the joint angles at the first of a sequence of tool poses, 1xN cell, that are found from the starts of an arm: Nxn [rad]. From
% several starts, often almost the same posture is found: what an arm cannot do in one, it cannot do in the next one either.
  found = zeros(0, numel(arm.parked));
  for start = arm.starts'
    postures = solvePoses(arm, poses, start');
    if ~isempty(postures) && all(max(abs(found - postures(1, :)), [], 2) > constants().uses.same_posture_rad)
      found(end + 1, :) = postures(1, :);
    end
  end
end
