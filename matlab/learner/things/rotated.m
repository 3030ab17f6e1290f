function v = rotated(v, angle)
% Returns vectors, Nx2, rotated by an angle [rad].
  v = [v(:, 1) * cos(angle) - v(:, 2) * sin(angle), v(:, 1) * sin(angle) + v(:, 2) * cos(angle)];
end
