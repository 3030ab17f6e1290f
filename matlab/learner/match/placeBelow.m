function placed = placeBelow(step, shown, steps)
% Moves a step to where it must be below one of some steps that come back; [] if there is none.
%   shown  those steps as demonstrated
  placed = [];
  for k = 1:numel(steps)
    away = norm(step.position(1:2) - shown(k).position(1:2));
    if away < max(shown(k).size(1:2)) / 2
      placed = turnedAbout(shown(k), step, steps(k).yaw - shown(k).yaw, steps(k));
      return
    end
  end
end
