function walls = containerWalls(containers)
% Returns the walls of some containers, 1xN or [], as blocks, four of each.
  walls = noBlocks();
  thick = constants().clearance.wall;  % assumed; thinner walls keep fingers away as well
  for it = containers
    along = [cos(it.yaw), sin(it.yaw)];
    for side = [1, -1]
      for axis = [1, 2]
        normal = along;
        if axis == 2, normal = [-along(2), along(1)]; end
        sides = it.size(1:2);
        sides(axis) = thick;
        at = it.position(1:2) + side * (it.size(axis) - thick) / 2 * normal;
        walls(end + 1) = newBlock(it.color, [sides, it.size(3)], [at, it.position(3)], it.yaw);
      end
    end
  end
end
