function points = movedTo(points, block, place, turn)
% Returns points on a block, Nx3 [units], where it is moved to a place, x y z, and turned [rad].
  points = [rotated(points(:, 1:2) - block.position(1:2), turn), points(:, 3) - block.position(3)] + place;
end
