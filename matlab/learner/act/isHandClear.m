function yes = isHandClear(arm, found, others, held)
% Returns true if an arm, over and at a place where it takes or leaves a held block, touches neither the robot nor the
% table; its hand avoids the others there, and its forearm also the block.
%   found  its joint angles over and at the place, 2xn [rad]
  yes = isValidAt(arm, found(2, :)) && isArmClear(arm, found(1, :), [others, held]) && ...
        isArmClear(arm, found(2, :), [others, held]);
  if ~yes, return; end
  tool = smileForward(arm.robot, arm.name, found(2, :));
  points = tool(1:3, 4)' + arm.reach * [1; 0; -1; -2] * tool(1:3, 3)';
  yes = all(isPointClear(points, others, constants().motion_planning.arm_radius));
end
