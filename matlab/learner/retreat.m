function actions = retreat(robot, arm, q)
% Returns the actions of an arm that was stopped: opens the gripper, rises as far as possible, parks, and
% observes.
%   q  2x7, joint angles of the arms [rad]
  names = {'left', 'right'};
  c = constants().motion_planning;
  actions = {struct('kind', 'open', 'arm', arm, 'to', c.retreat_opening)};
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
  actions{end + 1} = struct('kind', 'observe');
end
