function [actions, reason] = planAside(robot, eye, block, others, building, q, goal)
% The actions that bring a block to a free place on the table that the eye sees, if possible off the
% building's site; {} and a reason if there is none.
%   goal  where another arm shall bring it from there at once, or [] if that does not matter yet
  actions = {};
  reason = 'there is no free place on the table';
  sites = {asBlocks(building.steps)};
  if ~isempty(goal), sites{2} = asBlocks(building.steps(building.done)); end
  for site = sites
    tries = 8;
    for place = freePlaces(block, [others, site{1}], goal)
      if ~isSeen(place, eye) || isempty(fingerTurns(place, site{1})) || ...
         ~canPassOn(robot, block, place, goal)
        continue
      end
      [actions, reason] = planCarry(robot, block, place, others, q);
      tries = tries - 1;
      if ~isempty(actions), return; end
      if tries == 0, break; end
    end
  end
end

function places = freePlaces(block, taken, goal)
% Where a block might lie on the table, the best places first, up to 60: with room for fingers, its own
% and those of its neighbors.
  [x, y, yaw] = ndgrid(-6.5:0.5:6.5, -5:0.25:0, [0, pi / 2, pi / 4, -pi / 4]);
  x = x(:);
  y = y(:);
  covered = [x, y, repmat(block.size(1:2), numel(x), 1) + 0.2, yaw(:)];
  with_fingers = covered + [0, 0, 0, 0.7, 0];
  free = true(numel(x), 1);
  for rectangle = footprint(taken, 0.1)', free = free & ~overlap(rectangle', with_fingers); end
  for rectangle = gripRoom(taken)', free = free & ~overlap(rectangle', covered); end

  if isempty(goal)
    way = sqrt((x - block.position(1)) .^ 2 + (y - block.position(2)) .^ 2);
  else
    way = abs(x) + 0.1 * abs(y + 3.5);  % in the middle both arms reach most
  end
  way(~free) = Inf;
  [~, order] = sort(way);
  places = repmat(block, 1, min(60, sum(free)));
  for i = 1:numel(places)
    places(i).position = [covered(order(i), 1:2), block.size(3) / 2];
    places(i).yaw = covered(order(i), 5);
  end
end

function yes = isSeen(place, eye)
% Whether all of its top is in the eye's picture.
  yes = true;
  for corner = [1, 1, -1, -1; 1, -1, -1, 1] / 2
    along = corner(1) * place.size(1) * [cos(place.yaw), sin(place.yaw)];
    across = corner(2) * place.size(2) * [-sin(place.yaw), cos(place.yaw)];
    pixel = toPixel([place.position(1:2) + along + across, place.size(3)], eye);
    yes = yes && all(pixel > 3) && all(pixel < 2 * eye.intrinsics(1:2, 3)' - 3);
  end
end

function blocks = asBlocks(steps)
  blocks = rmfield(steps, {'name', 'on'});
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
