function found = columnsOf(poses, k)
% Returns a column of the upper rows of poses, 4x4xN, as rows, Nx3: 1 to 3 are the axes, 4 is the position [units].
  found = reshape(poses(1:3, k, :), 3, [])';
end
