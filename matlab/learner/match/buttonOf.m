function button = buttonOf(press, alignment, surface, shown)
% Returns the part that sticks out most of all that a press changes, as a block of no height: the raised button; a 1x0 struct
% array if nothing is seen there. Its bottom is how low the changed part is. Closed fingers side by side are to lie along it,
% so that they touch nothing else.
%   alignment, surface  see align, surfaceOf
%   shown               the eye of the demonstration
  c = constants().presses;
  button = noBlocks();
  [seen, before, later] = shownPart(press.changed, press, alignment, surface, shown);
  seen = partOfSurface(seen, isAlike(before, seen.colors) | isAlike(later, seen.colors));
  if isempty(seen.points), return; end
  top = max(seen.points(:, 3));
  edge = mean(seen.points(seen.points(:, 3) > top - c.edge_depth, :), 1);
  near = surfaceAround(surface, edge, c.button_radius, rows(surface.points)).points;
  raised = near(abs(near(:, 3) - top) < c.edge_depth, :);
  low = min(seen.points(:, 3));
  high = median(raised(:, 3));
  button(1) = newBlock(mean(seen.colors, 1), [c.finger_width, c.finger_width, high - low], ...
                       [mean(raised(:, 1:2), 1), (low + high) / 2], longerDirection(raised(:, 1:2)) - pi / 2);
end

function angle = longerDirection(points)
% Returns the direction in which N points, Nx2, extend most [rad].
  d = points - mean(points, 1);
  angle = atan2(2 * sum(d(:, 1) .* d(:, 2)), sum(d(:, 1) .^ 2 - d(:, 2) .^ 2)) / 2;
end
