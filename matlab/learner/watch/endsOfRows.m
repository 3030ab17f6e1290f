function ends = endsOfRows(row, column)
% Returns the numbers of the pixels at the ends of their rows and columns, Nx1.
  ends = unique([endsOf(row, column); endsOf(column, row)]);
end

function ends = endsOf(one, other)
% Returns the numbers of the first and the last pixel of each row, or column.
  [~, order] = sortrows([one, other]);
  first = [1; 1 + find(diff(one(order)))];
  ends = order([first; first(2:end) - 1; numel(order)]);
end
