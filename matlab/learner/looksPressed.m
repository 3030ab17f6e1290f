function yes = looksPressed(press, alignment, surface, shown)
% Returns true if what a press changes looks more as it did after the demonstrated press than before.
%   alignment, surface  see align, surfaceOf
%   shown               the eye of the demonstration
  [seen, before, later] = changedPart(press, alignment, surface, shown);
  away = max(abs(seen.colors - before), [], 2);
  toward = max(abs(seen.colors - later), [], 2);
  yes = sum(toward < away) > sum(away < toward);
end
