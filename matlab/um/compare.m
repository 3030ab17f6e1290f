function [building, used] = compare(building)
% Which steps are done, going by what is known of the blocks, and which of the blocks make them so.
%   used  which of the known blocks are where a step wants one, 1xN logical
  c = constants().decide;
  known = building.known;
  used = false(1, numel(known));
  building.done(:) = false;
  for k = 1:numel(building.steps)
    step = building.steps(k);
    for i = find(~used)
      off = [norm(known(i).position - step.position), abs(turnBetween(step, known(i).yaw))];
      if isLike(known(i), step) && off(1) < c.near && off(2) < c.even_rad
        building.miss(k, :) = off;
        building.done(k) = true;
        used(i) = true;
        break
      end
    end
  end
end
