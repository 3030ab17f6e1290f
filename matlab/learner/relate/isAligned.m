function yes = isAligned(one, other)
% Returns true if the sides of two blocks are parallel; what looks the same at each yaw, like discs, has none.
  angle = one.yaw - other.yaw;
  yes = abs(angle - pi / 2 * round(angle / (pi / 2))) < constants().relate.aligned_rad && ...
        yawDifference(one, one.yaw + 1) ~= 0 && yawDifference(other, other.yaw + 1) ~= 0;
end
