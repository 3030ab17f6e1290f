function faces = findOutlines(picture, eye, color, height)
% The rectangles of a color that may be rims of open boxes, at a height [units]: a 1xN struct array as
% from describeFace, the largest first, the first side the longer one. What is inside of them does not
% matter.
  faces = struct('center', {}, 'yaw', {}, 'sides', {}, 'misfit', {});
  if isempty(color), return; end
  number = labelRegions(isColor(picture, color));
  for region = find(accumarray(number(number > 0), 1) >= constants().see.outline_pixels)'
    mask = number == region;
    filled = cumsum(mask, 2) > 0 & fliplr(cumsum(fliplr(mask), 2)) > 0;
    [row, column] = find(filled);
    [x, y, area] = ontoPlane(row, column, eye, height);
    face = describeFace(x, y, area);
    if face.misfit < constants().see.misfit, faces(end + 1) = face; end
  end
  [~, order] = sort(-arrayfun(@(face) prod(face.sides), faces));
  faces = faces(order);
end
