function arms = nearestFirst(arms, x)
% Returns arms in the order in which they are tried at a place to the right of the middle (x > 0) or to the
% left of it.
  if isempty(arms), return; end
  feet = vertcat(arms.foot);
  sides = feet(:, 1);
  if x > 0, sides = -sides; end
  [~, order] = sort(sides);
  arms = arms(order');
end
