function skyline = widened(skyline, margin)
% Returns the skyline (see skylineOf) of the same things with a margin on all sides [units].
  cell_size = constants().skyline.cell;
  n = ceil(margin / cell_size);
  [num_rows, num_columns] = size(skyline.heights);
  wide = zeros([num_rows, num_columns] + 2 * n);
  for i = -n:n
    for j = -n:n
      if hypot(i, j) * cell_size > margin, continue; end
      in_rows = n + i + (1:num_rows);
      in_columns = n + j + (1:num_columns);
      wide(in_rows, in_columns) = max(wide(in_rows, in_columns), skyline.heights);
    end
  end
  skyline = struct('heights', wide, 'corner', skyline.corner - n * cell_size);
end
