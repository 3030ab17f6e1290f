function yes = looksPressed(press, alignment, surface, shown)
% Returns true if what a press changes looks more as it did after the demonstrated press than before, and what only other
% presses of the control change, as after it, too: a second lamp may be on.
%   alignment, surface  see align, surfaceOf
%   shown               the eye of the demonstration
  [seen, before, later] = shownPart(press.changed, press, alignment, surface, shown);
  away = max(abs(seen.colors - before), [], 2);
  toward = max(abs(seen.colors - later), [], 2);
  yes = sum(toward < away) > sum(away < toward);
  for n = 1:max(press.unchanged(:)) * yes
    [seen, ~, later] = shownPart(press.unchanged == n, press, alignment, surface, shown);
    yes = yes && sum(isAlike(seen.colors, later)) >= rows(later) / 2;
  end
end
