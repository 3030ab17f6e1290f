function yes = standsOn(upper, lower)
% Returns true if the bottom of a block, or a step's object, touches the top of another one.
  gap = (upper.position(3) - upper.size(3) / 2) - (lower.position(3) + lower.size(3) / 2);
  yes = abs(gap) < constants().task_model.max_support_gap && ...
        overlap(footprint(upper, 0), footprint(lower, 0));
end
