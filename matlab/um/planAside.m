function [actions, reason] = planAside(robot, block, others, building, q, goal)
% The actions that bring a block to a free place on the table, off the building's site; {} and a reason
% if there is none.
%   goal  where another arm shall bring it from there, or [] if that does not matter yet
  actions = {};
  reason = 'there is no free place on the table';
  blocked = [footprint(others, 0.1); footprint(building.steps, 0.1)];
  rooms = [gripRoom(others); gripRoom(building.steps)];

  [x, y, yaw] = ndgrid(-6:0.5:6, -5:0.25:-0.5, [0, pi / 2, pi / 4, -pi / 4]);
  way = sqrt((x - block.position(1)) .^ 2 + (y - block.position(2)) .^ 2);
  if ~isempty(goal), way = abs(x) + 0.1 * abs(y + 3.5); end  % in the middle both arms reach most
  [~, order] = sort(way(:));
  for i = order'
    place = block;
    place.position = [x(i), y(i), block.size(3) / 2];
    place.yaw = yaw(i);
    if ~isFree(place, blocked, rooms) || ~canPassOn(robot, block, place, goal), continue; end
    [actions, reason] = planCarry(robot, block, place, others, q);
    if ~isempty(actions), return; end
  end
end

function yes = isFree(place, blocked, rooms)
% With room for fingers, its own and those of its neighbors.
  yes = ~any(overlap(gripRoom(place), blocked)) && ~any(overlap(footprint(place, 0.1), rooms));
end

function yes = canPassOn(robot, block, place, goal)
% Whether one arm can bring the block to a place, and, if there is a goal, another from there to it.
  yes = false;
  for arm = 1:2
    yes = yes || (isWithinReach(robot, arm, block) && isWithinReach(robot, arm, place) && ...
                  (isempty(goal) || (isWithinReach(robot, 3 - arm, place) && ...
                                     isWithinReach(robot, 3 - arm, goal))));
  end
end
