function yes = isLevel(heights)
% Returns true if the heights of some pixels, Nx1, are those of one level area above the table.
  c = constants().perception;
  ordered = sort(heights);
  at = ordered(1 + floor([0.1, 0.5, 0.9] * (numel(ordered) - 1)));
  yes = at(2) > c.on_table && at(3) - at(1) < c.height_step;
end
