function points = pointsFromWrist(arm, q)
% Returns points along an arm, from its wrist to its first joint, at joint angles, Nxn [rad]: Mx3 [units], those of one row of
% angles after those of another.
  c = constants().motion_planning;
  ends = armPoints(arm, q);
  points = pointsBetween(ends, c.points_per_link);
  % Keeps the lines from the first end on that is away from the tool.
  is_far = sum((ends - ends(1, :, :)) .^ 2, 2) > c.min_wrist_distance ^ 2;
  is_behind = cummax(double(is_far(1:end - 1, 1, :)), 1);
  points = points(kron(is_behind(:), ones(c.points_per_link, 1)) > 0, :);
end
