function yes = isBeside(one, other)
% Returns true if two blocks are side by side, almost in contact.
  height = abs(one.position(3) - other.position(3));
  rectangle = footprint(other, 0);
  yes = 2 * height < one.size(3) + other.size(3) && ~overlap(footprint(one, 0), rectangle) && ...
        overlap(footprint(one, constants().relate.max_gap_beside), rectangle);
end
