function yes = isBeside(some, other)
% Returns which of N blocks are side by side with another one, almost in contact: 1xN logical.
  yes = false(1, 0);
  if isempty(some), return; end
  height = abs(vertcat(some.position)(:, 3) - other.position(3));
  is_level = 2 * height < vertcat(some.size)(:, 3) + other.size(3);
  rectangle = footprint(other, 0);
  is_close = overlap(rectangle, footprint(some, constants().relate.max_gap_beside));
  yes = (is_level & is_close & ~overlap(rectangle, footprint(some, 0)))';
end
