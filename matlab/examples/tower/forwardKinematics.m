function [position, rotation] = forwardKinematics(q, arm)
% Where the tool is for any seven angles, from the arm's mount, along the table's axes [units].
% rotation is 3x3: its columns are the tool's axes, y across the fingers and z along them.
  s = armShape(arm);
  %     out      turn     along                 zero
  dh = [s.out,   -pi/2,   s.up,                 0      % S0
        0,        pi/2,   0,                    pi/2   % S1
        s.elbow, -pi/2,   s.upper,              0      % E0
        0,        pi/2,   0,                    0      % E1
        s.wrist, -pi/2,   s.fore,               0      % W0
        0,        pi/2,   0,                    0      % W1
        0,        0,      s.hand,               0];    % W2
  pose = turnAboutZ(s.heading);
  for i = 1:7
    % Denavit-Hartenberg: turn about z, go along z, go out along x, turn about x.
    c = cos(dh(i, 2));
    n = sin(dh(i, 2));
    link = [1 0 0 dh(i, 1); 0 c -n 0; 0 n c dh(i, 3); 0 0 0 1];
    pose = pose * turnAboutZ(q(i) + dh(i, 4)) * link;
  end
  position = pose(1:3, 4)';
  rotation = pose(1:3, 1:3);
end

function pose = turnAboutZ(angle)
  pose = [cos(angle) -sin(angle) 0 0; sin(angle) cos(angle) 0 0; 0 0 1 0; 0 0 0 1];
end
