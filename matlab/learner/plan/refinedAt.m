function alignment = refinedAt(drive, alignment, surface, shown)
% Returns an alignment that is more accurate at the fasteners of a drive, by what the scene shows within a short distance.
  places = vertcat(drive.turns.place);
  is_near = false(rows(surface.points), 1);
  for k = 1:rows(places)
    places(k, 1:2) = rotated(places(k, 1:2) - alignment.place, -alignment.angle);
    away = surface.points(:, 1:2) - places(k, 1:2);
    is_near = is_near | hypot(away(:, 1), away(:, 2)) < constants().uses.refining_radius;
  end
  [~, alignment] = refinedAlignment(partOfSurface(surface, is_near), alignment, mean(places, 1), drive.before, shown);
end
