function now = corrected(seen, verdicts)
% Returns the known blocks after an observation: those seen, and those that were known before and are hidden
% now. A block whose top is partly hidden is where it was known to be.
  now = seen;
  for it = verdicts
    if ~strcmp(it.word, 'hidden'), continue; end
    if isempty(it.found)
      now(end + 1) = it.expected;
    else
      now(it.found) = it.expected;
    end
  end
end
