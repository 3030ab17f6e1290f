function yes = isArmClear(arm, q, blocks)
% Returns true if an arm that holds its tool straight down avoids blocks from its wrist on. (graspYaws checks
% the hand.)
%   q  its joint angles, 1xn [rad]
  yes = all(isPointClear(pointsFromWrist(arm, q), blocks, constants().motion_planning.arm_radius));
end
