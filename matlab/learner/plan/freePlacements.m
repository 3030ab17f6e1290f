function places = freePlacements(arms, eye, block, taken, goal, unexplained)
% Returns free places for a block on the table, within the eye's view, the best first, up to max_places: with
% room for its fingers and for those of its neighbors, and away from the feet of the arms.
%   taken        blocks to keep clear of
%   goal         to which it goes on from there, or []
%   unexplained  as from unexplainedPoints
  c = constants().task_planning;
  [x, depth, yaw] = ndgrid(c.place_x(1):c.place_x(2):c.place_x(3), ...
                           c.place_depth(1):c.place_depth(2):c.place_depth(3), [0, pi / 2, pi / 4, -pi / 4]);
  x = x(:);
  y = nearEdge(eye) + depth(:);
  covered = [x, y, repmat(block.size(1:2), numel(x), 1) + c.place_margin, yaw(:)];
  free = isFree(covered, taken);
  for arm = arms
    free = free & sqrt((x - arm.foot(1)) .^ 2 + (y - arm.foot(2)) .^ 2) > c.foot_distance;
  end
  free(free) = ~isUnexplained(covered(free, :), unexplained);
  inside = covered(free, :) - [0, 0, c.place_margin, c.place_margin, 0];
  free(free) = isOnTable(inside, eye) & isInView(inside, block.size(3), eye);

  if isempty(goal)
    % The middle, where both arms reach, is for handovers.
    cost = sqrt((x - block.position(1)) .^ 2 + (y - block.position(2)) .^ 2) + ...
           max(c.handover_half_width - abs(x), 0);
  else
    cost = abs(x) + c.handover_depth_cost * abs(depth(:) - c.handover_depth);
  end
  cost(~free) = Inf;
  [~, order] = sort(cost);
  places = repmat(block, 1, min(c.max_places, sum(free)));
  for i = 1:numel(places)
    places(i).position = [covered(order(i), 1:2), block.size(3) / 2];
    places(i).yaw = covered(order(i), 5);
  end
end
