function yes = isAligned(one, other)
% Returns true if the sides of two blocks are parallel; discs have none.
  angle = one.yaw - other.yaw;
  yes = abs(angle - pi / 2 * round(angle / (pi / 2))) < constants().relate.aligned_rad && ...
        ~isRound(one) && ~isRound(other);
end
