function [score, alignment] = align(surface, picture, eye, mask)
% Aligns a scene with a picture of the demonstration, which has no depth, around the pixels of a mask: what the eye sees in
% the scene, moved to where it was in the demonstration, must look there as it does in the picture. The pixels' most frequent
% colors are looked for in the scene: each point of such a color may be what one of the pixels shows.
%   surface    see surfaceOf
%   score      fraction of the points that look alike
%   alignment  how the scene lies in the demonstration: a point p of it, x y, was at `place` + p rotated by `angle` [rad];
%              [] if there is none
  c = constants().alignment;
  scores = zeros(0, 1);
  places = zeros(0, 3);  % angle and place
  points = zeros(0, 3);
  for pixel = referencePixels(picture, mask)
    color = reshape(picture(pixel(1), pixel(2), :), 1, 3);
    of_color = surface.points(isAlike(color, surface.colors), :);
    for point = of_color(1:max(1, floor(rows(of_color) / c.num_points)):end, :)'
      [x, y] = ontoPlane(pixel(1), pixel(2), eye, point(3));
      near = surfaceAround(surface, point, c.radius, c.num_coarse);
      [found, shares] = turnsAbout(near, point', [x, y], picture, eye);
      scores = [scores; shares];
      places = [places; found];
      points = [points; repmat(point', rows(found), 1)];
    end
  end
  [sorted, order] = sort(-scores);
  score = 0;
  alignment = [];
  for k = order(sorted < 0)(1:min(c.num_refined, end))'
    near = surfaceAround(surface, points(k, :), c.radius, c.num_fine);
    rough = struct('angle', places(k, 1), 'place', places(k, 2:3));
    [share, fine] = refinedAlignment(near, rough, points(k, :), picture, eye);
    if share > score
      score = share;
      alignment = fine;
    end
  end
end

function [found, shares] = turnsAbout(surface, point, place, picture, eye)
% Returns the alignments with which a point of the scene was at a place, x y, rows of angle and place; and the fractions of
% the points that look alike.
  angles = (0:constants().alignment.turn_rad:2 * pi)';
  c = cos(angles);
  s = sin(angles);
  found = [angles, place(1) - (point(1) * c - point(2) * s), place(2) - (point(1) * s + point(2) * c)];
  % A row for each point of the surface, a column for each angle.
  x = surface.points(:, 1) * c' - surface.points(:, 2) * s' + found(:, 2)';
  y = surface.points(:, 1) * s' + surface.points(:, 2) * c' + found(:, 3)';
  z = repmat(surface.points(:, 3), 1, numel(angles));
  [pixels, inside] = pixelsOf([x(:), y(:), z(:)], eye, size(picture));
  is_alike = isAlike(colorsOf(picture, pixels), repmat(surface.colors, numel(angles), 1)) & inside;
  shares = sum(reshape(is_alike, size(x)), 1)' / rows(x);
end
