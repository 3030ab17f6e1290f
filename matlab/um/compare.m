function [building, used] = compare(building, seen)
% Which steps are done, going by what is seen, and which of the seen blocks make them so.
%   used  1xnumel(seen), true for the blocks that are where a step wants one
%
% What carries something cannot be seen. It counts as done if it once was and what it carries is there.
  near = 0.07;   % units
  even = 0.06;   % rad
  steps = building.steps;
  used = false(1, numel(seen));
  carries = false(1, numel(steps));  % something that is in its place
  for k = numel(steps):-1:1
    is_here = false;
    for i = find(~used)
      if ~isLike(seen(i), steps(k)), continue; end
      off = [norm(seen(i).position - steps(k).position), turnBetween(steps(k), seen(i).yaw)];
      if off(1) < near && off(2) < even
        building.miss(k, :) = off;
        used(i) = true;
        is_here = true;
        break
      end
    end
    building.done(k) = is_here || (building.done(k) && carries(k));
    if building.done(k), carries(steps(k).on) = true; end
  end
end
