function faces = detectRims(picture, eye, color, height)
% Detects rectangles of a color, 1x3, at a height [units], that may be the rims of open boxes; anything
% may be inside. Returns a 1xN struct array as from fitFace, the largest first, each with the longer side
% first.
  faces = struct('center', {}, 'yaw', {}, 'isRound', {}, 'sides', {}, 'misfit', {});
  if isempty(color), return; end
  number = labelRegions(colorMask(picture, color));
  for region = find(accumarray(number(number > 0), 1) >= constants().perception.min_rim_pixels)'
    mask = number == region;
    filled = cumsum(mask, 2) > 0 & fliplr(cumsum(fliplr(mask), 2)) > 0;
    [row, column] = find(filled);
    [x, y, area] = ontoPlane(row, column, eye, height);
    face = fitFace(x, y, area);
    if face.misfit < constants().perception.misfit, faces(end + 1) = face; end
  end
  [~, order] = sort(-arrayfun(@(face) prod(face.sides), faces));
  faces = faces(order);
end
