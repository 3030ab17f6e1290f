function q = solveArm(q, posture, arm)
% Changes the angles q until the tool is where `posture` (see postureOf) says, fingers straight down;
% [] if it cannot get there, or should not. A small change of the posture gives a small change of the
% angles.
%
% Six numbers are wanted and seven joints are there: E0 is fixed. The other six are found by
% Newton's method: go as if the arm were as linear as it looks right here, look again, repeat.
  shape = armShape(arm);
  q(3) = shape.swing;
  free = [1, 2, 4, 5, 6, 7];
  goal = [posture(2) * cos(posture(1)), posture(2) * sin(posture(1)), posture(3)];
  c = cos(posture(1) + posture(4));
  s = sin(posture(1) + posture(4));
  down = [c s 0; s -c 0; 0 0 -1];
  for i = 1:20
    [position, rotation, jacobian, elbow] = forwardKinematics(q, arm);
    % What is missing: a way, and a turn. The turn is half the sum of what each axis must turn.
    way = (goal - position)';
    turn = sum(cross(rotation, down), 2) / 2;
    if norm(way) < 1e-6 && norm(turn) < 1e-6
      if any(q < shape.lower) || any(q > shape.upper) || hitsBody(posture, elbow, shape), q = []; end
      return
    end
    q(free) = q(free) + (jacobian(:, free) \ [way; turn])';
  end
  q = [];
end

function yes = hitsBody(posture, elbow, shape)
% The elbow comes close to the screen; or the tool is so far on the other arm's side that the upper
% arm comes close to the chest.
  across = abs(posture(1) - shape.heading);
  yes = norm(elbow - shape.head) < 1.95 || across > 95 * pi / 180;
end
