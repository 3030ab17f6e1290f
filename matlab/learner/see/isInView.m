function yes = isInView(places, top, eye)
% Returns which of N places are entirely in the eye's picture: Nx1 logical.
%   places  Nx5 as from footprint
%   top     height of the top of a block there [units]
  yes = true(rows(places), 1);
  margin = constants().task_planning.picture_margin_pixels;
  turn_cos = cos(places(:, 5));
  turn_sin = sin(places(:, 5));
  for corner = [1, 1, -1, -1; 1, -1, -1, 1] / 2
    along = corner(1) * places(:, 3);
    across = corner(2) * places(:, 4);
    points = places(:, 1:2) + [along .* turn_cos - across .* turn_sin, along .* turn_sin + across .* turn_cos];
    pixels = toPixel([points, repmat(top, rows(points), 1)], eye);
    yes = yes & all(pixels > margin & pixels < 2 * eye.intrinsics(1:2, 3)' - margin, 2);
  end
end
