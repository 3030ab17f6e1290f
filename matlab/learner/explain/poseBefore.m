function pose = poseBefore(demo, n, frame)
% Returns the pose of object n of a demonstration before an action of a frame: 1x6 [units, degrees].
  moves = demo.moves(demo.moves(:, 2) == n, [1, 3:8]);
  pose = moves(max(sum(moves(:, 1) < frame), 1), 2:7);
end
