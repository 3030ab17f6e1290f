function shape = armShape(arm)
% Baxter's arm in units of 0.1 m and in radians; arm 1 is the left one, 2 the right one.
%   shape.zero, along, out, cos_turn, sin_turn  how the joints S0 to W2 follow one another, after
%                   Denavit and Hartenberg: see forwardKinematics
%   shape.heading   where S0 = 0 points, seen from above, counted from the table's x axis
%   shape.lower, shape.upper, shape.fastest  what the joints can
%   shape.head      the corner of the screen that the elbow might hit, seen from the arm's mount
%   shape.swing     what E0 is set to, always: it turns the elbow outwards. With E0 = 0 the elbow would
%                   be straight above the hand and hit the screen when the hand works in front of it
%   shape.twist     the twist (see postureOf) at which the wrist W2 is in the middle of its range
  %                 S0      S1    E0      E1  W0      W1  W2, to the point between the fingers
  shape.zero =     [0,      pi/2, 0,      0,  0,      0,  0];
  shape.along =    [2.7035, 0,    3.6442, 0,  3.7429, 0,  2.29525 + 0.818];
  shape.out =      [0.69,   0,    0.69,   0,  0.10,   0,  0];
  shape.cos_turn = [0,      0,    0,      0,  0,      0,  1];  % of -90, 90, -90, ... 0 degrees
  shape.sin_turn = [-1,     1,    -1,     1,  -1,     1,  0];
  sides = [1, -1];  % left, right
  shape.heading = pi / 2 + sides(arm) * pi / 4;
  shape.head = [sides(arm) * 1.79, 1.06, 6.2];
  shape.swing = -sides(arm) * 0.95;
  shape.twist = sides(arm) * 2.92;
  % E1 could stretch to -0.05, but a stretched arm needs wild speeds.
  shape.lower = [-1.70, -2.14, -3.05, 0.25, -3.05, -1.57, -3.05];
  shape.upper = [1.70, 1.04, 3.05, 2.61, 3.05, 2.09, 3.05];
  shape.fastest = [1.5, 1.5, 1.5, 1.5, 4, 4, 4];
end
