function yes = hasObjectsOn(block, others)
% Returns true if one of the others lies on a block.
  least = block.position(3) + block.size(3) / 2 - constants().task_planning.max_sinking;
  bottoms = arrayfun(@(it) it.position(3) - it.size(3) / 2, others);
  yes = any(overlap(footprint(block, 0), footprint(others(bottoms > least), 0)));
end
