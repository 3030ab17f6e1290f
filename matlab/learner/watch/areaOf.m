function area = areaOf(polygon)
% Returns the area of a polygon, Nx2.
  next = polygon([2:end, 1], :);
  area = abs(sum(polygon(:, 1) .* next(:, 2) - polygon(:, 2) .* next(:, 1))) / 2;
end
