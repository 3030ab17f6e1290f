function yes = isAbove(upper, lower)
% Returns true if a block is over another one, at any distance.
  c = constants().task_model;
  gap = (upper.position(3) - upper.size(3) / 2) - (lower.position(3) + lower.size(3) / 2);
  yes = gap > -c.max_support_gap && overlap(footprint(upper, -c.min_above), footprint(lower, 0));
end
