function faces = halfHiddenRims(picture, eye, color, height, center, yaw)
% Detects rectangles of a color, 1x3, at a height [units] around a center, 1x2, and at a yaw [rad], of which a part is hidden: three
% sides must be seen. The farther one of two opposite sides tells where both are. Returns a 1xN struct array as from fitFace, the largest first.
  faces = struct('center', {}, 'yaw', {}, 'isRound', {}, 'sides', {}, 'misfit', {});
  c = constants().perception;
  if max(abs(color - tableColor(picture))) < c.table_tolerance, return; end
  for it = filledRegions(picture, eye, color, height)
    points = rotated([it.x, it.y] - center, -yaw);
    ends = [max(points, [], 1); -min(points, [], 1)];
    sides = 2 * max(ends, [], 1);
    if any(ends(:) <= 0) || nnz(ends > c.reached_side * sides / 2) < 3, continue; end
    faces(end + 1) = struct('center', center, 'yaw', yaw, 'isRound', false, 'sides', sides, 'misfit', 0);
  end
  [~, order] = sort(-arrayfun(@(face) prod(face.sides), faces));
  faces = faces(order);
end
