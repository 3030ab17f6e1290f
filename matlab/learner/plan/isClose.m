function yes = isClose(block, place)
% Returns true if a block is so close to a place that fingers may touch both.
  near = constants().task_planning.near_distance + block.size(1) / 2;
  yes = norm(block.position - place.position) < near;
end
