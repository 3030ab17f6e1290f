function corners = cornersOfPlaces(places)
% Returns the corners of N places, Nx5 as from footprint: Nx2x4.
  turn_cos = cos(places(:, 5));
  turn_sin = sin(places(:, 5));
  corners = zeros(rows(places), 2, 4);
  sides = [1, 1, -1, -1; 1, -1, -1, 1] / 2;
  for k = 1:4
    along = sides(1, k) * places(:, 3);
    across = sides(2, k) * places(:, 4);
    corners(:, :, k) = places(:, 1:2) + ...
                       [along .* turn_cos - across .* turn_sin, along .* turn_sin + across .* turn_cos];
  end
end
