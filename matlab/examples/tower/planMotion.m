function motion = planMotion(q, goal, arm)
% Goes from the angles q to a posture, smoothly and as fast as the joints may; [] if the arm cannot.
% All four numbers of the posture change in proportion, so a change of height alone is an exact
% vertical line.
%   motion.angles    parts x 7: the joints' angles at equal parts of the way
%   motion.duration  [s]
  parts = 16;
  shape = armShape(arm);
  start = postureOf(q, arm);
  motion = [];
  angles = zeros(parts, 7);
  for i = 1:parts
    q = solveArm(q, start + (i - 1) / (parts - 1) * (goal - start), arm);
    if isempty(q), return; end
    angles(i, :) = q;
  end
  % With share = (1 - cos(pi t / duration)) / 2 the way is fastest in its middle, pi / 2 times as
  % fast as on average. The joints shall not need more than 0.7 of what they can.
  rates = max(abs(diff(angles)), [], 1) * (parts - 1);
  duration = pi / 2 * max(rates ./ (0.7 * shape.fastest));
  motion = struct('angles', angles, 'duration', max(duration, 0.4));
end
