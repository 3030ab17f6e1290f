function yes = isArmClear(arm, q, blocks)
% Returns true if an arm that holds its tool straight down avoids blocks from its wrist on. (graspYaws checks
% the hand.)
%   q  its joint angles, 1xn [rad]
  c = constants().motion_planning;
  tops = arrayfun(@(block) block.position(3) + block.size(3) / 2, blocks(:));
  covered = footprint(blocks, c.arm_radius);
  points = armPoints(arm, q);
  from_tool = sqrt(sum((points - points(1, :)) .^ 2, 2));
  yes = true;
  for k = find(from_tool > c.min_wrist_distance, 1):size(points, 1) - 1
    for fraction = linspace(0, 1, c.points_per_link)
      point = points(k, :) + fraction * (points(k + 1, :) - points(k, :));
      low = tops > point(3) - c.arm_radius;
      yes = yes && ~any(overlap([point(1:2), 0, 0, 0], covered(low, :)));
    end
  end
end
