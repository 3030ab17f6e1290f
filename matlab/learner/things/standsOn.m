function yes = standsOn(upper, lower)
% Returns true if the bottom of a block, or a step's object, touches the top of another one; for N of those, 1xN logical.
  yes = false(1, 0);
  if isempty(lower), return; end
  gap = (upper.position(3) - upper.size(3) / 2) - (vertcat(lower.position)(:, 3) + vertcat(lower.size)(:, 3) / 2);
  is_level = abs(gap') < constants().task_model.max_support_gap;
  yes = is_level;
  if any(is_level), yes = is_level & overlap(footprint(lower, 0), footprint(upper, 0)); end
end
