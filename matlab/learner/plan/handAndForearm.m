function lowest = handAndForearm(arm, q, tools)
% Returns the lowest points of an arm at joint angles, from its hand to its first joint, and its fingertips, Mx3 [units].
%   q      joint angles, Nxn [rad]
%   tools  its poses there, 4x4xN
  c = constants().motion_planning;
  hands = columnsOf(tools, 4);
  tips = hands + arm.reach * columnsOf(tools, 3);
  lowest = [tips; hands; linksOf(arm, q) - [0, 0, c.arm_radius]];
end
