function y = nearEdge(eye)
% Returns the y of the edge of the table at which the robot stands [units].
  y = -eye.table(2) / 2;
end
