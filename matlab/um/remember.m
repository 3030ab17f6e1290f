function known = remember(known, seen, picture, eye)
% What is known of the blocks after a look: those seen, and those that were known before and may be
% hidden now, by what was built or by what lies on them. Where the table is seen, nothing is left.
  table = tableColor(picture);
  for block = known
    same = arrayfun(@(other) norm(other.position - block.position) < constants().decide.same_block, seen);
    if any(same) || showsTable(picture, eye, block, table), continue; end
    seen(end + 1) = block;
  end
  known = seen;
end
