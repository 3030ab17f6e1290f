function yes = isIn(one, other)
% Returns true if two blocks would be in each other.
  c = constants();
  gap = c.task_model.max_support_gap;
  bottoms = [one.position(3) - one.size(3) / 2, other.position(3) - other.size(3) / 2];
  tops = [one.position(3) + one.size(3) / 2, other.position(3) + other.size(3) / 2];
  yes = bottoms(1) < tops(2) - gap && bottoms(2) < tops(1) - gap && ...
        overlap(footprint(one, -c.watching.max_within), footprint(other, -c.watching.max_within));
end
