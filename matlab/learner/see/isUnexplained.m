function yes = isUnexplained(places, points)
% Returns which of N places, Nx5 as from footprint, contain some points, as from unexplainedPoints, or have them
% where open fingers are beside a block there: Nx1 logical.
  c = constants().perception;
  sides = places(:, 3:4) + 2 * c.unexplained_fingers;
  turn_cos = cos(places(:, 5));
  turn_sin = sin(places(:, 5));
  count = zeros(rows(places), 1);
  at_once = 1000;  % points, to limit the memory
  for first = 1:at_once:rows(points)
    some = points(first:min(first + at_once - 1, end), :)';
    x = some(1, :) - places(:, 1);
    y = some(2, :) - places(:, 2);
    inside = 2 * abs(x .* turn_cos + y .* turn_sin) < sides(:, 1) & ...
             2 * abs(y .* turn_cos - x .* turn_sin) < sides(:, 2);
    count = count + sum(inside, 2);
  end
  yes = count >= c.min_unexplained;
end
