function sizes = onEachFace(sides)
% Returns the sizes of a block on its faces, 3x3, a row for each: as in turnedSize.
  for up = 1:3
    sizes(up, :) = [sort(sides([1:up - 1, up + 1:end]), 'descend'), sides(up)];
  end
end
