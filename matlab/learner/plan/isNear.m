function yes = isNear(place, left)
% Returns true if a place is close to one of some others.
  near = constants().task_planning.near_place_distance;
  yes = any(arrayfun(@(it) norm(it.position - place.position) < near, left));
end
