function actions = retreat(robot, arm, q)
% Lets go, goes up as far as possible, parks and looks again.
  names = {'left', 'right'};
  c = constants().carry;
  actions = {struct('kind', 'grip', 'arm', arm, 'to', c.retreat_opening)};
  here = smileForward(robot, names{arm}, q(arm, :));
  q = q(arm, :);
  for height = c.retreat_height:-c.retreat_step:here(3, 4) + c.retreat_step
    up = here;
    up(3, 4) = height;
    path = smileMoveLine(robot, names{arm}, q, up, 'speed', c.retreat_speed);
    if isempty(path), continue; end
    actions{end + 1} = struct('kind', 'follow', 'arm', arm, 'path', path);
    q = path.positions(end, :);
    break
  end
  actions{end + 1} = struct('kind', 'follow', 'arm', arm, ...
                            'path', moveJoints(robot, arm, [q; parkedAngles(arm)]));
  actions{end + 1} = struct('kind', 'look');
end
