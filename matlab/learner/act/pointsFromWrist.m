function points = pointsFromWrist(arm, q)
% Returns points along an arm, from its wrist to its first joint: Nx3 [units].
%   q  its joint angles, 1xn [rad]
  c = constants().motion_planning;
  ends = armPoints(arm, q);
  from_tool = sqrt(sum((ends - ends(1, :)) .^ 2, 2));
  points = pointsBetween(ends(find(from_tool > c.min_wrist_distance, 1):end, :), c.points_per_link);
end
