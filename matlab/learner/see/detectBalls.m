function balls = detectBalls(picture, eye, kinds, heights)
% Detects balls of some kinds: a 1xN struct array, see newBlock. A part of each may be hidden.
%   kinds    blocks or steps
%   heights  as from heightMap
  balls = noBlocks();
  c = constants();
  for kind = kinds
    number = labelRegions(shadeMask(picture, kind.color), heights);
    for region = find(accumarray(number(number > 0), 1) >= c.perception.min_top_pixels)'
      pixels = find(number == region);
      z = heights(pixels);
      if max(z) < c.perception.on_table, continue; end
      [row, column] = ind2sub(size(number), pixels);
      [x, y] = ontoPlane(row, column, eye, z);
      [center, radius, misfit] = fitSphere([x, y, z]);
      is_of_size = abs(2 * radius / kind.size(1) - 1) < c.perception.max_side_error;
      if is_of_size && misfit < c.balls.misfit
        balls(end + 1) = newBlock(kind.color, kind.size, center, 0, 'ball');
      end
    end
  end
end

function [center, radius, misfit] = fitSphere(points)
% Fits a sphere to points of its surface, Nx3. Returns its center, its radius, and the mean distance of the
% points from it.
% |p - c| = r is linear in the unknowns c and r^2 - |c|^2: 2 p c + (r^2 - |c|^2) = |p|^2.
  found = [2 * points, ones(rows(points), 1)] \ sum(points .^ 2, 2);
  center = found(1:3)';
  radius = sqrt(max(found(4) + center * center', 0));
  misfit = mean(abs(sqrt(sum((points - center) .^ 2, 2)) - radius));
end
