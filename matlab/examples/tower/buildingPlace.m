function goal = buildingPlace(k, seen)
% A place in the middle, where both arms reach, far from the blocks that lie there already.
  best = -Inf;
  for x = -1:0.25:1
    for y = -3.5:0.25:-1.75
      room = 2.5;  % more than that is of no use
      for i = [1:k - 1, k + 1:numel(seen)]
        if ~isempty(seen{i}), room = min(room, norm(seen{i}.position(1:2) - [x, y])); end
      end
      worth = room - 0.1 * norm([x, y + 2.5]);
      if worth > best
        best = worth;
        goal = struct('position', [x, y, 1], 'yaw', 0);
      end
    end
  end
end
