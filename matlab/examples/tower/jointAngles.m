function q = jointAngles(posture, arm)
% The seven angles of an arm whose tool points straight down (so E0 = W0 = 0), 1x7; [] when the
% tool cannot get there.
%   posture = [S0, distance, height, W2]: of the tool, from the axis of S0 and from the arm's mount
%   [units and rad]. With E0 = W0 = 0 the arm lies in one upright plane, so these say it all.
  s = armShape(arm);
  q = [];
  % The wrist W1 hangs exactly above the tool. From S1 it lies `ahead` and `below`.
  ahead = posture(2) - s.out;
  below = s.up - (posture(3) + s.hand);

  % S1, E1 and W1 are the corners of a triangle with these sides.
  a = hypot(s.upper, s.elbow);
  b = hypot(s.fore, s.wrist);
  c = hypot(ahead, below);
  if c > 0.99 * (a + b) || c < a - b, return; end
  at_s1 = acos((a^2 + c^2 - b^2) / (2 * a * c));
  at_w1 = acos((b^2 + c^2 - a^2) / (2 * b * c));

  % Angles count downwards from the horizontal. The elbow is the upper one of two possible, and the
  % short steps at the ends of the links tilt the sides of the triangle.
  slope = atan2(below, ahead);
  upper = slope - at_s1 - atan2(s.elbow, s.upper);
  fore = slope + at_w1 - atan2(s.wrist, s.fore);
  angles = [posture(1), upper, 0, fore - upper, 0, pi / 2 - fore, posture(4)];
  if withinLimits(angles), q = angles; end
end

function yes = withinLimits(q)
  lower = [-1.70, -2.14, -3.05, -0.05, -3.05, -1.57, -3.05];
  upper = [1.70, 1.04, 3.05, 2.61, 3.05, 2.09, 3.05];
  yes = all(q >= lower) && all(q <= upper);
end
