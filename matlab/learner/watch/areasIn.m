function areas = areasIn(mask, smallest)
% Returns the rows and columns of the connected regions of a mask, HxW logical, with some number of pixels or more: a 1xN
% cell of Mx2.
  areas = {};
  if nnz(mask) < smallest, return; end
  inside = find(mask);
  number = labelRegions(mask);
  number = number(inside);
  [region, begin] = unique(number, 'first');
  often = accumarray(number, 1);
  [~, order] = sort(begin);
  for k = region(order)'
    if often(k) < smallest, continue; end
    [row, column] = ind2sub(size(mask), inside(number == k));
    areas{end + 1} = [row, column];
  end
end
