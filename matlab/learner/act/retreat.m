function actions = retreat(arm, q, can_rise)
% Returns the actions of an arm that was stopped: opens the gripper, rises as far as possible, parks, and
% observes.
%   q         its joint angles, 1xn [rad]
%   can_rise  false if it was stopped while rising: then it parks directly
  c = constants().motion_planning;
  actions = {struct('kind', 'open', 'arm', arm, 'to', min(c.retreat_opening, arm.opening))};
  here = smileForward(arm.robot, arm.name, q);
  heights = c.retreat_height:-c.retreat_step:here(3, 4) + c.retreat_step;
  for height = heights(heights & can_rise)
    up = here;
    up(3, 4) = height;
    path = smileMoveLine(arm.robot, arm.name, q, up, 'speed', c.retreat_speed);
    if isempty(path), continue; end
    actions{end + 1} = struct('kind', 'follow', 'arm', arm, 'path', path);
    q = path.positions(end, :);
    break
  end
  actions{end + 1} = struct('kind', 'follow', 'arm', arm, 'path', moveJoints(arm, [q; arm.parked]));
  actions{end + 1} = struct('kind', 'observe');
end
