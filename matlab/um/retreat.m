function actions = retreat(robot, arm, q)
% Lets go, goes up as far as possible, parks and looks again.
  names = {'left', 'right'};
  actions = {struct('kind', 'grip', 'arm', arm, 'to', 1.6)};
  here = smileForward(robot, names{arm}, q(arm, :));
  q = q(arm, :);
  for height = 5:-0.5:here(3, 4) + 0.5
    up = here;
    up(3, 4) = height;
    path = smileMoveLine(robot, names{arm}, q, up, 'speed', 0.5);
    if isempty(path), continue; end
    actions{end + 1} = struct('kind', 'follow', 'arm', arm, 'path', path);
    q = path.positions(end, :);
    break
  end
  actions{end + 1} = struct('kind', 'follow', 'arm', arm, ...
                            'path', moveJoints(robot, arm, [q; parkedAngles(arm)]));
  actions{end + 1} = struct('kind', 'look');
end
