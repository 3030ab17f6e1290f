function lowest = handAndForearm(arm, q, tools)
% Returns the lowest points of an arm at joint angles, from its hand to its first joint, and its fingertips, Mx3 [units].
%   q      joint angles, Nxn [rad]
%   tools  its poses there, 1xN cell of 4x4
  c = constants().motion_planning;
  fingers = cellfun(@(it) it(1:3, 4)' + [arm.reach; 0] * it(1:3, 3)', tools(:), 'UniformOutput', false);
  lowest = [vertcat(fingers{:}); pointsBetween(armPoints(arm, q), c.points_per_link) - [0, 0, c.arm_radius]];
end
