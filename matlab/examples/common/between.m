function points = between(points, low, high)
% Returns the points (Nx3) at heights from low to high.
  points = points(points(:, 3) > low & points(:, 3) < high, :);
end
