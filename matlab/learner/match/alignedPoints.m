function points = alignedPoints(alignment, points)
% Returns where points of the scene, Nx3 [units], were in the demonstration: see align.
  points(:, 1:2) = rotated(points(:, 1:2), alignment.angle) + alignment.place;
end
