function away = besideTouching(goal, others)
% Returns how far beside its place a block is lowered, 1x2 [units]: away from others that it touches there, if there is room.
% From there it is slid against them. Lowered right beside them, it may catch on their tops, as no place is exact.
%   goal  the block at its place
  c = constants().motion_planning;
  half = goal.size(3) / 2;
  isLevel = @(it) it.position(3) + it.size(3) / 2 > goal.position(3) - half + c.max_touching_gap && ...
                  it.position(3) - it.size(3) / 2 < goal.position(3) + half;
  level = footprint(others(arrayfun(isLevel, others)), 0);
  isNear = @(k, width) any(overlap(level, stripBeside(goal, k, width)));
  away = [0, 0];
  for k = 0:3
    if ~isNear(k, c.max_touching_gap) || isNear(mod(k + 2, 4), 2 * c.beside_distance), continue; end
    yaw = goal.yaw + k * pi / 2;
    away = away - c.beside_distance * [cos(yaw), sin(yaw)];
  end
end

function strip = stripBeside(block, k, width)
% Returns the area along a side of a block, with a width [units], 1x5: see footprint.
%   k  the side, 0 to 3: at the end of its longer side, then counterclockwise
  across = block.size(1 + mod(k, 2));
  along = block.size(2 - mod(k, 2)) - 2 * constants().motion_planning.max_touching_gap;
  yaw = block.yaw + k * pi / 2;
  strip = [block.position(1:2) + (across + width) / 2 * [cos(yaw), sin(yaw)], width, along, yaw];
end
