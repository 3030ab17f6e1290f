function faces = detectRims(picture, eye, color, height)
% Detects rectangles of a color, 1x3, at a height [units], that may be the rims of open boxes; anything
% may be inside. Returns a 1xN struct array as from fitFace, the largest first, each with the longer side
% first.
  faces = struct('center', {}, 'yaw', {}, 'isRound', {}, 'sides', {}, 'misfit', {});
  if isempty(color), return; end
  number = labelRegions(colorMask(picture, color));
  for region = find(accumarray(number(number > 0), 1) >= constants().perception.min_rim_pixels)'
    [row, column] = filledRegion(number == region);
    [x, y, area] = ontoPlane(row, column, eye, height);
    face = fitFace(x, y, area);
    if face.misfit < constants().perception.misfit, faces(end + 1) = face; end
  end
  [~, order] = sort(-arrayfun(@(face) prod(face.sides), faces));
  faces = faces(order);
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
