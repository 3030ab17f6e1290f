function [actions, state] = planLookAside(places, state, eye, arm, sensor)
% Plans to move an arm from the line of sight to one of some places on the table, Nx2 [units], the first if possible, and to look
% there: a 1xN cell of actions; {} if it hides none of them, or finds no posture to wait in meanwhile.
  actions = {};
  q = sensor.arms(arm.index).joints(:)';
  hidden = places(hides(linksOf(arm, q), places, eye), :);
  if isempty(hidden), return; end
  % The nearest first, each with the path there, and which places it shows.
  postures = struct('path', {}, 'shown', {}, 'q', {});
  angles = turnsOf(arm);
  [~, order] = sort(abs(angles - q(1)));
  for angle = angles(order)
    posture = [angle, arm.parked(2:end)];
    shown = ~hides(linksOf(arm, posture), hidden, eye);
    if ~any(shown), continue; end
    path = moveJoints(arm, [q; posture]);
    if ~isPathValid(arm, path) || ~isPathOver(arm, path, state.known), continue; end
    postures(end + 1) = struct('path', path, 'shown', shown, 'q', posture);
  end
  for k = 1:rows(hidden)
    for posture = postures
      if ~posture.shown(k), continue; end
      place = hidden(k, :);
      state.handLooks(end + 1, :) = place;
      tool = smileForward(arm.robot, arm.name, posture.q);
      state.grasp = newGrasp(tool(1:3, 4)', arm, 0);  % what fails if the arm is stopped: no grasp of a block
      text = sprintf('looks at (%.2f, %.2f), which arm %s hid from the eye', place, arm.name);
      state.notes(end + 1) = asNote('action', text);
      actions = {struct('kind', 'follow', 'arm', arm, 'path', posture.path), struct('kind', 'observe')};
      return
    end
  end
end

function yes = hides(links, places, eye)
% Returns at which places on the table, Nx2 [units], an arm, points along it, comes close to the line of sight from the eye: Nx1
% logical.
  radius = constants().motion_planning.arm_radius;
  yes = false(rows(places), 1);
  for k = 1:rows(places)
    start = [places(k, :), 0];
    sight = eye.pose(1:3, 4)' - start;
    along = min(max((links - start) * sight' / (sight * sight'), 0), 1);
    yes(k) = any(sumsq(links - start - along * sight, 2) < radius ^ 2);
  end
end
