function walls = wallsOf(container)
% What stands around the inside of a container, as four blocks; none of [].
  walls = noBlocks();
  if isempty(container), return; end
  thick = constants().room.wall;  % thinner ones keep fingers off as well
  along = [cos(container.yaw), sin(container.yaw)];
  for side = [1, -1]
    for axis = [1, 2]
      way = along;
      if axis == 2, way = [-along(2), along(1)]; end
      sides = container.size(1:2);
      sides(axis) = thick;
      at = container.position(1:2) + side * (container.size(axis) - thick) / 2 * way;
      walls(end + 1) = struct('color', container.color, 'size', [sides, container.size(3)], ...
                              'position', [at, container.position(3)], 'yaw', container.yaw);
    end
  end
end
