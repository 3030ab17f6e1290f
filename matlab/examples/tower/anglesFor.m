function q = anglesFor(posture, arm)
% The joint angles for a posture, wherever the arm is now; [] if it cannot get there.
%
% Newton's method wants to begin near. So the arm is first turned with S0, which turns it as a whole,
% and then brought from its parked height and distance to the goal in a few steps.
  q = parkedAngles(arm);
  start = postureOf(q, arm);
  q(1) = q(1) + posture(1) - start(1);
  start(1) = posture(1);
  for share = [0.4, 0.7, 1]
    q = solveArm(q, start + share * (posture - start), arm);
    if isempty(q), return; end
  end
end
