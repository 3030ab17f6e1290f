function yes = isSamePlace(one, other)
% Returns true if two blocks are one that did not move.
  c = constants().watching;
  yes = isequal(one.size, other.size) && sameColor(one.color, other.color) && ...
        norm(one.position - other.position) < c.same_place && abs(yawDifference(one, other.yaw)) < c.same_yaw_rad;
end
