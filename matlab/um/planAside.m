function [actions, reason] = planAside(robot, block, others, building, q, goal)
% The actions that bring a block to a free place on the table, off the building's site; {} and a reason
% if there is none.
%   goal  where it shall go from there, or [] if that does not matter yet
  actions = {};
  reason = 'there is no free place on the table';
  places = zeros(0, 4);  % x, y, yaw, and how far off
  for yaw = [0, pi / 2, pi / 4, -pi / 4]
    for x = -6:0.5:6
      for y = -5:0.25:-0.5
        place = placeAt(block, [x, y, yaw]);
        if ~isFree(place, others, building.steps), continue; end
        way = norm([x, y] - block.position(1:2)) + 2 * max(abs(x) - 3, 0);
        if ~isempty(goal), way = abs(x); end
        places(end + 1, :) = [x, y, yaw, way];
      end
    end
  end
  places = sortrows(places, 4);
  for i = 1:min(100, size(places, 1))
    place = placeAt(block, places(i, 1:3));
    if ~isempty(goal) && isempty(planCarry(robot, place, goal, others, q)), continue; end
    [actions, reason] = planCarry(robot, block, place, others, q);
    if ~isempty(actions), return; end
  end
end

function place = placeAt(block, pose)
  place = block;
  place.position = [pose(1:2), block.size(3) / 2];
  place.yaw = pose(3);
end

function yes = isFree(place, others, steps)
% With room for fingers at its long sides, and off the building's site.
  yes = true;
  for other = others, yes = yes && isApart(place, other); end
  for step = steps, yes = yes && isApart(place, step); end
end

function yes = isApart(place, other)
  yes = ~overlap(gripRoom(place), footprint(other, 0.1)) && ~overlap(footprint(place, 0.1), gripRoom(other));
end
