function sides = turnedSize(sides, held)
% Returns the size of a block, its longer side, its shorter one and its height, after a turn by 90 degrees about the side by
% which it is held: 1 for the longer one, 2 for the shorter.
  sides = [sort(sides([held, 3]), 'descend'), sides(3 - held)];
end
