function yes = areCovered(points, blocks, margin)
% Returns which of N points are in the areas of some blocks, with a margin [units]: Nx1 logical.
  yes = any(overlap([points, zeros(rows(points), 3)], footprint(blocks, margin)), 1)';
end
