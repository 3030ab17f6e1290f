function [middle, axes] = rectangleAround(points)
% Returns the smallest upright rectangle around points (Nx3), as seen from above: its middle (1x2), and the directions
% of its sides (2x2, one in each row, the long one first).
  least = Inf;
  for angle = (0:0.5:89.5) * pi / 180
    directions = [cos(angle), sin(angle); -sin(angle), cos(angle)];
    along = points(:, 1:2) * directions';
    low = min(along, [], 1);
    high = max(along, [], 1);
    if prod(high - low) < least
      least = prod(high - low);
      lengths = high - low;
      middle = (low + high) / 2 * directions;
      axes = directions;
    end
  end
  [~, order] = sort(lengths, 'descend');
  axes = axes(order, :);
end
