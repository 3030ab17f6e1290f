function yes = isPointClear(points, blocks, margin)
% Returns which of N points, Nx3, are above or beside all blocks, with a margin [units]: Nx1 logical.
  tops = blockTops(blocks)';
  covered = footprint(blocks, constants().motion_planning.arm_radius);
  places = [points(:, 1:2), zeros(rows(points), 3)];
  yes = ~any(overlap(covered, places) & tops > points(:, 3) - margin, 2);
end
