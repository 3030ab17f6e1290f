function lowest = handAndForearm(arm, q, tool)
% Returns the lowest points of an arm at joint angles, 1xn [rad], from its hand to its first joint, and its fingertips, Nx3.
%   tool  its pose there, 4x4
  c = constants().motion_planning;
  lowest = tool(1:3, 4)' + [arm.reach; 0] * tool(1:3, 3)';
  points = armPoints(arm, q);
  fractions = linspace(0, 1, c.points_per_link)';
  for k = 1:rows(points) - 1
    link = points(k, :) + fractions * (points(k + 1, :) - points(k, :));
    lowest = [lowest; link - [0, 0, c.arm_radius]];
  end
end
