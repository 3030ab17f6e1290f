function building = chooseSite(building, seen, robot)
% Chooses where the building shall stand: where the arms reach each place, with few blocks in the way.
% The steps are shifted there. Without such a site, hasSite stays false and the summary says so.
  shown = vertcat(building.steps.position);
  middle = (min(shown, [], 1) + max(shown, [], 1)) / 2;
  best = Inf;
  for x = -1:0.5:1
    for y = -3.5:0.25:-0.5
      shift = [[x, y] - middle(1:2), 0];
      steps = building.steps;
      for k = 1:numel(steps), steps(k).position = steps(k).position + shift; end
      % Far from the robot the building hides nothing, and nearer the arms reach more.
      cost = inTheWay(steps, seen) + 0.1 * abs(y + 1.25) + 0.01 * abs(x);
      if cost < best && isReachable(steps, robot)
        best = cost;
        chosen = steps;
      end
    end
  end
  building.hasSite = isfinite(best);
  if building.hasSite
    building.steps = chosen;
  else
    building.summary = 'no place on the table is within reach for all of the building';
  end
end

function count = inTheWay(steps, seen)
  count = 0;
  for block = seen
    for step = steps
      if overlap(footprint(block, 0.1), gripRoom(step)), count = count + 1; end
    end
  end
end

function yes = isReachable(steps, robot)
% Each place must be within reach of some arm, and 2 units above it, too.
  names = {'left', 'right'};
  yes = true;
  for k = 1:numel(steps)
    arm = 1 + (steps(k).position(1) > 0);
    for height = [steps(k).position(3) + 0.3, steps(k).position(3) + 2]
      pose = toolPose([steps(k).position(1:2), height], steps(k).yaw + pi / 2);
      yes = yes && ~isempty(smileInverse(robot, names{arm}, pose, parkedAngles(arm), ...
                                         'maxIterations', 300));
    end
    if ~yes, return; end
  end
end
