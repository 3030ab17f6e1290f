function regions = displacedRegions(mask, other)
% Returns the connected regions of a mask that are mostly outside another mask: a 1xN cell of Nx2 [row,
% column].
  number = labelRegions(mask);
  regions = {};
  for region = find(accumarray(number(number > 0), 1) >= constants().perception.min_top_pixels)'
    [row, column] = find(number == region);
    remaining = mean(other(number == region));
    if remaining < constants().task_model.max_remaining_fraction, regions{end + 1} = [row, column]; end
  end
end
