function yaw = squareYaw(x, y, area)
% How a square is turned [rad], from small pieces of it around its center.
%
% Multiplying complex numbers adds their angles, so (x + iy)^4 turns four times as fast as the square
% and is the same for all four corners, which are farthest out and count most. Their sum points away
% from the sum over the middles of the sides: at 0 degrees the corners lie at 45, four times that is
% 180, hence the minus.
  yaw = angle(-sum(area .* (x + 1i * y) .^ 4)) / 4;
end
