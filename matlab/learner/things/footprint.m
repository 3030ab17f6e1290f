function rectangles = footprint(blocks, margin)
% Returns the areas that blocks cover, seen from above, with a margin on all sides [units]: Nx5 rectangles
% for overlap; each row is x and y of the center, both sides [units], and the yaw of the first side [rad].
  if isempty(blocks)
    rectangles = zeros(0, 5);
    return
  end
  places = vertcat(blocks.position);
  sizes = vertcat(blocks.size);
  rectangles = [places(:, 1:2), sizes(:, 1:2) + 2 * margin, vertcat(blocks.yaw)];
end
