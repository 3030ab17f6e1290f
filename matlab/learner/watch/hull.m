function corners = hull(points)
% Returns the convex hull of points in a plane, Nx2, in turn. Source: A. M. Andrew, "Another efficient algorithm for convex
% hulls in two dimensions" (1979).
  ordered = sortrows(points);
  corners = [chain(ordered); chain(flipud(ordered))];
end

function found = chain(points)
% Returns one half of the hull of ordered points, without its end.
  found = zeros(0, 2);
  for p = points'
    while rows(found) > 1 && turn(found(end - 1, :), found(end, :), p') <= 0, found(end, :) = []; end
    found(end + 1, :) = p';
  end
  found(end, :) = [];
end

function area = turn(a, b, c)
% Returns twice the area of a triangle, positive if its corners turn left.
  area = (b(1) - a(1)) * (c(2) - a(2)) - (b(2) - a(2)) * (c(1) - a(1));
end
