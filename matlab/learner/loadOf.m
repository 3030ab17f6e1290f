function load = loadOf(points, middle, tool)
% Returns what a hand carries: points on it in the frame of the tool, Nx3 [units]. Those are the visible points of an object,
% Nx3, when it is taken with the tool at a pose, 4x4. Below the height of its middle [units], which is not visible, it is taken
% to be as above.
  [~, first] = unique(cellsOf(points, [0, 0]), 'rows', 'first');
  above = points(first, :);
  whole = [above; above .* [1, 1, -1] + [0, 0, 2 * middle]];
  load = (whole - tool(1:3, 4)') * tool(1:3, 1:3);
end
