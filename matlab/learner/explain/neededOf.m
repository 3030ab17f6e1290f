function needed = neededOf(moved, demo, needs)
% Returns the needed ones of some moved objects, their numbers: those whose places count, and those that were moved in a
% needed subtask. All of them if none would remain.
%   needs  see needsOf; [] if unknown
  needed = moved;
  if isempty(needs), return; end
  counts = ismember(demo.ids(moved), needs.goals);
  was_needed = arrayfun(@(n) any(arrayfun(@(it) isNeeded(needs, it), needs.releases{n})), moved);
  if any(counts | was_needed), needed = moved(counts | was_needed); end
end
