function yes = atBorder(row, column, shape)
% Returns true if pixels reach the border of a picture of a shape [height, width].
  yes = min([row; column]) == 1 || max(row) == shape(1) || max(column) == shape(2);
end
