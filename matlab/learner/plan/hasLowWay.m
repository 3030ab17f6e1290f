function yes = hasLowWay(block, goal, others)
% Returns true if there is no obstacle higher than a block around the first half of its way to a goal.
  width = constants().motion_planning.low_way_width;
  way = (goal.position(1:2) - block.position(1:2)) / 2;
  area = [block.position(1:2) + way / 2, norm(way) + width, width, atan2(way(2), way(1))];
  tops = arrayfun(@(it) it.position(3) + it.size(3) / 2, others);
  higher = others(tops > block.position(3) + block.size(3) / 2);
  yes = ~any(overlap(area, footprint(higher, 0)));
end
