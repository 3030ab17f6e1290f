function columns = clearMatches(changes)
% Returns for each row of colorChanges the column that matches it, 1xN; NaN if it has none, or if it is not clear
% which. No column matches two rows. The whole change is the least possible.
  [least, columns] = leastChange(changes, []);
  for i = find(~isnan(columns))
    others = changes;
    others(i, columns(i)) = Inf;
    if leastChange(others, []) - least < constants().light.min_advantage, columns(i) = NaN; end
  end
end

function [best, columns] = leastChange(changes, taken)
% Returns the least whole change with which each row has a column of its own, or none, which counts as much as
% the greatest change; and these columns, NaN for none.
  best = 0;
  columns = zeros(1, 0);
  if rows(changes) == 0, return; end
  [total, others] = leastChange(changes(2:end, :), taken);
  best = constants().light.max_change + total;
  columns = [NaN, others];
  for k = setdiff(find(isfinite(changes(1, :))), taken)
    [total, others] = leastChange(changes(2:end, :), [taken, k]);
    if changes(1, k) + total < best
      best = changes(1, k) + total;
      columns = [k, others];
    end
  end
end
