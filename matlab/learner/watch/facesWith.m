function faces = facesWith(around, whole, seen)
% Returns the faces of a whole size that contain a smaller one and share a border with it in each direction, a 1xN struct array.
%   around  the smaller one, see smallestRectangle
%   seen    how much of the top is visible: if it is little, one side must be visible entirely
  c = constants().watching;
  faces = struct('center', {}, 'yaw', {}, 'sides', {});
  quarters = 0;
  if whole(1) / whole(2) > 1 + c.same_kind, quarters = [0, 1]; end
  for quarter = quarters
    sides = circshift(whole(1:2), quarter, 2);
    missing = sides - around.sides;
    is_long = any(missing < c.max_missing);
    if any(missing < -c.max_side_error * sides) || ~is_long && seen < c.min_seen_edge, continue; end
    for along = shiftsBy(missing(1), c.max_missing)
      for across = shiftsBy(missing(2), c.max_missing)
        center = around.center + rotated([along, across], around.yaw);
        faces(end + 1) = struct('center', center, 'yaw', around.yaw + quarter * pi / 2, 'sides', whole(1:2));
      end
    end
  end
end

function shifts = shiftsBy(missing, most)
% Returns how far the middle may be from that of the visible part, in one direction, 1x1 or 1x2 [units].
  shifts = [-missing, missing] / 2;
  if abs(missing) < most, shifts = 0; end
end
