function [position, rotation, jacobian, elbow] = forwardKinematics(q, arm)
% Where the tool, the point between the fingers, is at these seven angles.
%   position  from the arm's mount, along the table's axes, 1x3 [units]
%   rotation  3x3: its columns are the tool's axes, y across the fingers and z along them
%   jacobian  6x7: how fast the tool moves (rows 1 to 3) and turns (4 to 6) for each joint's rate
%   elbow     where the joint E1 is, 1x3 [units]
  shape = armShape(arm);
  % Each step from joint to joint, after Denavit and Hartenberg: turn about z by the joint's angle, go
  % along z and out along x, turn about x. All seven at once, as that is quicker here.
  c = cos(q + shape.zero);
  s = sin(q + shape.zero);
  step = zeros(4, 4, 7);
  step(1, 1, :) = c;
  step(2, 1, :) = s;
  step(1, 2, :) = -s .* shape.cos_turn;
  step(2, 2, :) = c .* shape.cos_turn;
  step(3, 2, :) = shape.sin_turn;
  step(1, 3, :) = s .* shape.sin_turn;
  step(2, 3, :) = -c .* shape.sin_turn;
  step(3, 3, :) = shape.cos_turn;
  step(1, 4, :) = shape.out .* c;
  step(2, 4, :) = shape.out .* s;
  step(3, 4, :) = shape.along;
  step(4, 4, :) = 1;

  pose = zeros(4, 4, 8);  % of the seven joints and of the tool
  pose(:, :, 1) = [cos(shape.heading), -sin(shape.heading), 0, 0
                   sin(shape.heading), cos(shape.heading), 0, 0
                   0, 0, 1, 0
                   0, 0, 0, 1];
  for i = 1:7
    pose(:, :, i + 1) = pose(:, :, i) * step(:, :, i);
  end
  position = pose(1:3, 4, 8)';
  rotation = pose(1:3, 1:3, 8);
  elbow = pose(1:3, 4, 4)';

  % Each joint turns the tool about its z axis, and moves it at right angles to axis and lever.
  axis = reshape(pose(1:3, 3, 1:7), 3, 7);
  lever = position' - reshape(pose(1:3, 4, 1:7), 3, 7);
  jacobian = [axis([2 3 1], :) .* lever([3 1 2], :) - axis([3 1 2], :) .* lever([2 3 1], :); axis];
end
