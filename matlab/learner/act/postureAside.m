function best = postureAside(arm, eye, is_left)
% Returns joint angles of an arm beside the table: its hand as high as possible, its first joint turned
% until the eye sees least of it, outward beside other arms.
  c = constants().arms;
  q_high = raisedPosture(arm);
  best = q_high;
  lowest = [Inf, Inf, Inf];
  for angle = turnsOf(arm)
    q = [angle, q_high(2:end)];
    is_outward = (angle > q_high(1)) == is_left;
    if ~isValidAt(arm, q) || (arm.hasTorso && ~is_outward), continue; end
    cost = [visibleExtent(armPoints(arm, q), eye), ~is_outward, abs(angle - q_high(1))];
    better = find(cost ~= lowest, 1);
    if ~isempty(better) && cost(better) < lowest(better)
      lowest = cost;
      best = q;
    end
  end
end

function extent = visibleExtent(points, eye)
% Returns how much of the lines between points is in the eye's picture: the sum of the distances of points
% on them from its border [pixels]. Beyond the border, thick links may still be visible.
  c = constants().arms;
  size_px = 2 * eye.intrinsics(1:2, 3)';
  margin = c.parked_margin * size_px;
  extent = 0;
  for point = pointsBetween(points, c.points_per_link)'
    if (point' - eye.pose(1:3, 4)') * eye.pose(1:3, 3) > 0  % in front of the eye
      pixel = toPixel(point', eye);
      extent = extent + max(0, min([pixel + margin, size_px + margin - pixel]));
    end
  end
  extent = round(extent);
end
