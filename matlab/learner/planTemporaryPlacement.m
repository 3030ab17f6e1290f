function [actions, place, reason] = planTemporaryPlacement(arms, eye, block, others, sites, sensor, goal, failures, left)
% Plans the actions that bring a block to a free place on the table, within the eye's view. Returns them
% and that place; {} and a reason if there is none.
%   others  obstacles, as blocks
%   sites   cell of lists of blocks to keep clear of, existing or planned; the first list that leaves a
%           place counts
%   goal    target to which an arm must be able to move it from there, or []
%   failures  grasps that are not to be repeated
%   left      places to which it does not return, as blocks
  actions = {};
  place = noBlocks();
  reason = 'there is no free place on the table';
  if ~canReach(arms, block)
    reason = 'no arm reaches it';
    return
  end
  for site = sites
    tried = noBlocks();
    for place = freePlacements(arms, block, [others, site{1}], goal)
      has_yaw = tried([tried.yaw] == place.yaw);
      if isNear(place, left) || isNear(place, has_yaw) || ~isInView(place, eye) || ...
         isGraspBlocked(place, site{1}) || ...
         isTopHidden(place, site{1}, eye) || blocksGrasps(place, others) || ~canReach(arms, place)
        continue
      end
      can_continue = isempty(goal) || ~isempty(planPickAndPlace(arms, place, goal, others, sensor, []));
      if can_continue, [actions, reason] = planPickAndPlace(arms, block, place, others, sensor, failures); end
      if ~isempty(actions), return; end
      tried(end + 1) = asBlocks(place);
      if numel(tried) == constants().task_planning.max_place_attempts, break; end
    end
  end
end

function places = freePlacements(arms, block, taken, goal)
% Returns free places for a block on the table, the best first, up to max_places: with room for its
% fingers and for those of its neighbors, and away from the feet of the arms.
  c = constants().task_planning;
  [x, y, yaw] = ndgrid(c.place_x(1):c.place_x(2):c.place_x(3), c.place_y(1):c.place_y(2):c.place_y(3), ...
                       [0, pi / 2, pi / 4, -pi / 4]);
  x = x(:);
  y = y(:);
  covered = [x, y, repmat(block.size(1:2), numel(x), 1) + c.place_margin, yaw(:)];
  with_fingers = covered + [0, 0, 0, c.place_fingers, 0];
  free = true(numel(x), 1);
  margin = constants().clearance.site_margin;
  for rectangle = footprint(taken, margin)', free = free & ~overlap(rectangle', with_fingers); end
  % Square blocks can also be held across the other sides.
  is_long = ~arrayfun(@hasEqualSides, taken);
  for rectangle = gripperClearance(taken(is_long))', free = free & ~overlap(rectangle', covered); end
  for arm = arms
    free = free & sqrt((x - arm.foot(1)) .^ 2 + (y - arm.foot(2)) .^ 2) > c.foot_distance;
  end

  if isempty(goal)
    % The middle, where both arms reach, is for handovers.
    cost = sqrt((x - block.position(1)) .^ 2 + (y - block.position(2)) .^ 2) + ...
           max(c.handover_half_width - abs(x), 0);
  else
    cost = abs(x) + c.handover_y_cost * abs(y - c.handover_y);
  end
  cost(~free) = Inf;
  [~, order] = sort(cost);
  places = repmat(block, 1, min(c.max_places, sum(free)));
  for i = 1:numel(places)
    places(i).position = [covered(order(i), 1:2), block.size(3) / 2];
    places(i).yaw = covered(order(i), 5);
  end
end

function yes = isNear(place, left)
% Returns true if a place is close to one of some others.
  near = constants().task_planning.near_place_distance;
  yes = any(arrayfun(@(it) norm(it.position - place.position) < near, left));
end

function yes = blocksGrasps(place, others)
% Returns true if a block at a place would leave no room for the fingers at one of the others that can be
% grasped without it.
  yes = false;
  place = asBlocks(place);
  for i = find(arrayfun(@(it) isClose(it, place), others))
    rest = others([1:i - 1, i + 1:end]);
    yes = ~isempty(graspYaws(others(i), rest)) && isempty(graspYaws(others(i), [rest, place]));
    if yes, return; end
  end
end

function yes = isInView(place, eye)
% Returns true if the whole top of a block at a place is in the eye's picture.
  yes = true;
  margin = constants().task_planning.picture_margin_pixels;
  for corner = [1, 1, -1, -1; 1, -1, -1, 1] / 2
    along = corner(1) * place.size(1) * [cos(place.yaw), sin(place.yaw)];
    across = corner(2) * place.size(2) * [-sin(place.yaw), cos(place.yaw)];
    pixel = toPixel([place.position(1:2) + along + across, place.size(3)], eye);
    yes = yes && all(pixel > margin) && all(pixel < 2 * eye.intrinsics(1:2, 3)' - margin);
  end
end

function yes = canReach(arms, place)
% Returns true if one of the arms reaches a block's place.
  yes = any(arrayfun(@(arm) isReachable(arm, place), arms));
end
