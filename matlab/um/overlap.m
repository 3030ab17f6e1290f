function yes = overlap(one, many)
% Whether a rectangle, 1x5 (see footprint), has points in common with each of many, Nx5: Nx1 logical. Two
% rectangles are apart if, in the direction of one of their sides, there is a gap between them.
  gap = many(:, 1:2) - one(1:2);
  yes = true(size(many, 1), 1);
  for yaw = {one(5), one(5) + pi / 2, many(:, 5), many(:, 5) + pi / 2}
    apart = abs(gap(:, 1) .* cos(yaw{1}) + gap(:, 2) .* sin(yaw{1}));
    yes = yes & apart < reach(one, yaw{1}) + reach(many, yaw{1});
  end
end

function half = reach(rectangles, yaw)
% How far they reach from their centers in a direction.
  turn = yaw - rectangles(:, 5);
  half = (rectangles(:, 3) .* abs(cos(turn)) + rectangles(:, 4) .* abs(sin(turn))) / 2;
end
