function now = corrected(seen, verdicts)
% Returns the known blocks after an observation: those seen, and those that were known before and are hidden
% now. A block whose top is partly hidden is where it was known to be.
  hidden = verdicts(strcmp({verdicts.word}, 'hidden'));
  known = [hidden.expected];
  is_pieced_together = false(1, numel(seen));  % arrayfun makes of no blocks a 0x0 matrix
  for k = 1:numel(seen), is_pieced_together(k) = isPiecedTogether(seen(k), known); end
  is_pieced_together([verdicts.found]) = false;
  now = seen;
  for it = hidden(~cellfun(@isempty, {hidden.found})), now(it.found) = it.expected; end
  now = [now(~is_pieced_together), hidden(cellfun(@isempty, {hidden.found})).expected];
end

function yes = isPiecedTogether(block, hidden)
% Returns true if the top of a block that was seen consists of parts of the tops of blocks that are known to be there and
% partly hidden.
  margin = constants().beliefs.same_top;
  isLike = @(it) sameColor(it.color, block.color) && abs(blockTops(it) - blockTops(block)) < margin;
  points = topPoints(block);
  like = hidden(arrayfun(isLike, hidden));
  yes = ~isempty(like) && all(any(overlap(footprint(like, margin), [points(:, 1:2), zeros(rows(points), 3)]), 2));
end
