function walls = containerWalls(container)
% Returns the walls of a container as four blocks, or a 1x0 struct array for [].
  walls = noBlocks();
  if isempty(container), return; end
  thick = constants().clearance.wall;  % assumed; thinner walls keep fingers away as well
  along = [cos(container.yaw), sin(container.yaw)];
  for side = [1, -1]
    for axis = [1, 2]
      normal = along;
      if axis == 2, normal = [-along(2), along(1)]; end
      sides = container.size(1:2);
      sides(axis) = thick;
      at = container.position(1:2) + side * (container.size(axis) - thick) / 2 * normal;
      walls(end + 1) = newBlock(container.color, [sides, container.size(3)], [at, container.position(3)], ...
                                container.yaw);
    end
  end
end
