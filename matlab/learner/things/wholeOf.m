function whole = wholeOf(points, middle)
% Returns points on an object of which some points are visible, Nx3, one in each cell [units]. Below the height of its middle
% [units], which is not visible, it is taken to be as above.
  [~, first] = unique(cellsOf(points, [0, 0]), 'rows', 'first');
  above = points(first, :);
  whole = [above; above .* [1, 1, -1] + [0, 0, 2 * middle]];
end
