function angle = quarterTurn(angle)
% The same angle for a square, which looks the same every 90 degrees: -pi/4 to pi/4.
  angle = angle - pi / 2 * round(angle / (pi / 2));
end
