function [actions, place, reason] = planAside(robot, eye, block, others, sites, q, goal)
% The actions that bring a block to a free place on the table that the eye sees, and that place; {} and a
% reason if there is none.
%   sites  what is or will be built, to keep off, as a cell of lists: the first with which there is a place
%          counts
%   goal   where another arm shall bring it from there at once, or [] if that does not matter yet
  actions = {};
  place = noBlocks();
  reason = 'there is no free place on the table';
  arms = armsFor(robot, block, goal);
  if isempty(arms)
    reason = 'no arm reaches it';
    return
  end
  for site = sites
    tries = constants().decide.place_tries;
    for place = freePlaces(block, [others, site{1}], goal)
      if ~isSeen(place, eye) || isWalledIn(place, site{1}) || ...
         ~canPassOn(robot, arms, place, goal)
        continue
      end
      goes_on = isempty(goal) || ~isempty(planCarry(robot, place, goal, others, q));
      if goes_on, [actions, reason] = planCarry(robot, block, place, others, q); end
      tries = tries - 1;
      if ~isempty(actions), return; end
      if tries == 0, break; end
    end
  end
end

function places = freePlaces(block, taken, goal)
% Where a block might lie on the table, the best places first, up to 100: with room for fingers, its own
% and those of its neighbors.
  c = constants().decide;
  [x, y, yaw] = ndgrid(c.place_x(1):c.place_x(2):c.place_x(3), c.place_y(1):c.place_y(2):c.place_y(3), ...
                       [0, pi / 2, pi / 4, -pi / 4]);
  x = x(:);
  y = y(:);
  covered = [x, y, repmat(block.size(1:2), numel(x), 1) + c.place_margin, yaw(:)];
  with_fingers = covered + [0, 0, 0, c.place_fingers, 0];
  free = true(numel(x), 1);
  margin = constants().room.site_margin;
  for rectangle = footprint(taken, margin)', free = free & ~overlap(rectangle', with_fingers); end
  % Square blocks can be held the other way round, too.
  long = ~arrayfun(@hasEqualSides, taken);
  for rectangle = gripRoom(taken(long))', free = free & ~overlap(rectangle', covered); end

  if isempty(goal)
    % The middle, where both arms reach, is for passing on.
    way = sqrt((x - block.position(1)) .^ 2 + (y - block.position(2)) .^ 2) + max(c.middle - abs(x), 0);
  else
    way = abs(x) + c.passing_y_cost * abs(y - c.passing_y);
  end
  way(~free) = Inf;
  [~, order] = sort(way);
  places = repmat(block, 1, min(c.most_places, sum(free)));
  for i = 1:numel(places)
    places(i).position = [covered(order(i), 1:2), block.size(3) / 2];
    places(i).yaw = covered(order(i), 5);
  end
end

function yes = isSeen(place, eye)
% Whether all of its top is in the eye's picture.
  yes = true;
  margin = constants().decide.picture_margin_pixels;
  for corner = [1, 1, -1, -1; 1, -1, -1, 1] / 2
    along = corner(1) * place.size(1) * [cos(place.yaw), sin(place.yaw)];
    across = corner(2) * place.size(2) * [-sin(place.yaw), cos(place.yaw)];
    pixel = toPixel([place.position(1:2) + along + across, place.size(3)], eye);
    yes = yes && all(pixel > margin) && all(pixel < 2 * eye.intrinsics(1:2, 3)' - margin);
  end
end

function arms = armsFor(robot, block, goal)
% The arms, 1 or 2, that can bring a block somewhere from where another can bring it to a goal, if there
% is one.
  arms = find([isWithinReach(robot, 1, block), isWithinReach(robot, 2, block)]);
  if isempty(goal), return; end
  arms = arms(arrayfun(@(arm) isWithinReach(robot, 3 - arm, goal), arms));
end

function yes = canPassOn(robot, arms, place, goal)
% Whether one of these arms reaches a place, and the other one too if it is to go on from there.
  yes = false;
  for arm = arms
    yes = yes || (isWithinReach(robot, arm, place) && ...
                  (isempty(goal) || isWithinReach(robot, 3 - arm, place)));
  end
end
