function yes = belongsTo(block, points)
% Returns which of N visible points belong to a block or stick out of it, like the blades of scissors: those no higher than its
% top that are joined to it without a gap, Nx1 logical.
  c = constants().skyline;
  low = points(:, 3) < block.position(3) + block.size(3) / 2 + c.margin;
  [cells, ~, index] = unique(cellsOf(points(low, :), [0, 0]), 'rows');
  squares = [(cells + 0.5) * c.cell, repmat([c.cell, c.cell, 0], rows(cells), 1)];
  is_part = overlap(footprint(block, 0), squares);
  % From cell to cell, until no other one touches them.
  newest = find(is_part)';
  while ~isempty(newest)
    near = false(rows(cells), 1);
    for k = newest, near = near | max(abs(cells - cells(k, :)), [], 2) <= c.max_gap_cells; end
    newest = find(near & ~is_part)';
    is_part = is_part | near;
  end
  yes = false(rows(points), 1);
  yes(low) = is_part(index);
end
