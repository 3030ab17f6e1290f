function yes = isArmClear(arm, q, blocks)
% Returns true if an arm that holds its tool straight down avoids blocks from its wrist on. (graspYaws checks
% the hand.)
%   q  its joint angles, 1xn [rad]
  c = constants().motion_planning;
  tops = arrayfun(@(block) block.position(3) + block.size(3) / 2, blocks(:));
  ends = armPoints(arm, q);
  from_tool = sqrt(sum((ends - ends(1, :)) .^ 2, 2));
  ends = ends(find(from_tool > c.min_wrist_distance, 1):end, :);
  points = pointsBetween(ends, c.points_per_link);
  is_over = overlap([points(:, 1:2), zeros(rows(points), 3)], footprint(blocks, c.arm_radius));
  yes = ~any(any(is_over & tops > points(:, 3)' - c.arm_radius));
end
