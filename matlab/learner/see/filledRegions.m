function regions = filledRegions(picture, eye, color, height)
% Returns the regions of a color, 1x3 or [] for none, with what they surround, at a height [units]: a 1xN struct array.
%   x, y, area  of their pixels, Nx1 [units, units squared]
  regions = struct('x', {}, 'y', {}, 'area', {});
  if isempty(color), return; end
  number = labelRegions(colorMask(picture, color));
  for region = find(accumarray(number(number > 0), 1) >= constants().perception.min_rim_pixels)'
    [row, column] = filledRegion(number == region);
    [x, y, area] = ontoPlane(row, column, eye, height);
    regions(end + 1) = struct('x', x, 'y', y, 'area', area);
  end
end

function [row, column] = filledRegion(mask)
% Returns the pixels of a mask, and in each row those between them.
  in_rows = find(any(mask, 2));
  in_columns = find(any(mask, 1));
  part = mask(in_rows(1):in_rows(end), in_columns(1):in_columns(end));
  [row, column] = find(cumsum(part, 2) > 0 & fliplr(cumsum(fliplr(part), 2)) > 0);
  % Of a single row, find returns rows.
  row = row(:) + in_rows(1) - 1;
  column = column(:) + in_columns(1) - 1;
end
