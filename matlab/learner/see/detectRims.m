function faces = detectRims(picture, eye, color, height)
% Detects rectangles of a color, 1x3, at a height [units], that may be the rims of open boxes; anything
% may be inside. Returns a 1xN struct array as from fitFace, the largest first, each with the longer side
% first.
  faces = struct('center', {}, 'yaw', {}, 'isRound', {}, 'sides', {}, 'misfit', {});
  for region = filledRegions(picture, eye, color, height)
    face = fitFace(region.x, region.y, region.area);
    if face.misfit < constants().perception.misfit, faces(end + 1) = face; end
  end
  [~, order] = sort(-arrayfun(@(face) prod(face.sides), faces));
  faces = faces(order);
end
