function known = updateBeliefs(known, seen, picture, eye)
% Returns the known blocks after an observation: those seen, and those that were known before and may be
% occluded now. A block is forgotten where the table is visible.
  table = tableColor(picture);
  for block = known
    distances = arrayfun(@(other) norm(other.position - block.position), seen);
    same = distances < constants().task_planning.same_block_distance;
    if any(same) || isTableVisible(picture, eye, block, table), continue; end
    seen(end + 1) = block;
  end
  known = seen;
end
