function pose = poseOf(demo, n, frame)
% Returns the pose of object n before an action of a frame, 1x6: x y z [units], angles about x, y, z [degrees].
  rows = demo.moves(demo.moves(:, 2) == n, :);
  pose = rows(max(sum(rows(:, 1) < frame), 1), 3:8);
end
