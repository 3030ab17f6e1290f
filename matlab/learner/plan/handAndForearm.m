function lowest = handAndForearm(arm, q, tool)
% Returns the lowest points of an arm at joint angles, 1xn [rad], from its hand to its first joint, and its fingertips, Nx3.
%   tool  its pose there, 4x4
  c = constants().motion_planning;
  lowest = tool(1:3, 4)' + [arm.reach; 0] * tool(1:3, 3)';
  lowest = [lowest; pointsBetween(armPoints(arm, q), c.points_per_link) - [0, 0, c.arm_radius]];
end
