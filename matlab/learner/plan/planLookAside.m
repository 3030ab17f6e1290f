function [actions, state] = planLookAside(place, state, eye, arms, sensor)
% Plans to move an arm that hides a place, x y z [units], from the eye, and to look there: a 1xN cell of actions; {}
% if none does, or it finds no posture to wait in meanwhile. An arm that stands before the eye always hides something.
  c = constants().arms;
  actions = {};
  for arm = arms
    q = sensor.arms(arm.index).joints(:)';
    if ~hides(arm, q, place, eye), continue; end
    angles = arm.lower(1) * c.parked_limit:c.parked_turn_rad:arm.upper(1) * c.parked_limit + c.parked_turn_rad / 2;
    [~, order] = sort(abs(angles - q(1)));
    for angle = angles(order)
      there = [angle, arm.parked(2:end)];
      path = moveJoints(arm, [q; there]);
      if hides(arm, there, place, eye) || ~isPathValid(arm, path) || ~isPathOver(arm, path, state.known), continue; end
      state.handLooks(end + 1, :) = place(1:2);
      tool = smileForward(arm.robot, arm.name, there);
      state.grasp = newGrasp(tool(1:3, 4)', arm, 0);  % what fails if the arm is stopped: no grasp of a block
      text = sprintf('looks at (%.2f, %.2f), which arm %s hid from the eye', place(1:2), arm.name);
      state.notes(end + 1) = asNote('action', text);
      actions = {struct('kind', 'follow', 'arm', arm, 'path', path), struct('kind', 'observe')};
      return
    end
  end
end

function yes = hides(arm, q, place, eye)
% Returns true if an arm at joint angles comes close to the line of sight from the eye to a place.
  c = constants().motion_planning;
  sight = eye.pose(1:3, 4)' - place;
  points = pointsBetween(armPoints(arm, q), c.points_per_link) - place;
  along = min(max(points * sight' / (sight * sight'), 0), 1);
  yes = any(vecnorm(points - along * sight, 2, 2) < c.arm_radius);
end
