function yes = isWhole(row, column, solid)
% Returns true if pixels are surrounded by what they hide, so that nothing hides any of them.
%   solid  mask of that, HxW logical, as from solid
  yes = false;
  if atBorder(row, column, size(solid)), return; end
  top = min(row) - 1;
  left = min(column) - 1;
  own = false(max(row) + 2 - top, max(column) + 2 - left);
  own(sub2ind(size(own), row - top + 1, column - left + 1)) = true;
  around = false(size(own));
  around(2:end, :) = own(1:end - 1, :);
  around(1:end - 1, :) = around(1:end - 1, :) | own(2:end, :);
  around(:, 2:end) = around(:, 2:end) | own(:, 1:end - 1);
  around(:, 1:end - 1) = around(:, 1:end - 1) | own(:, 2:end);
  is_solid = solid(top:max(row) + 1, left:max(column) + 1);
  yes = nnz(around & ~own & ~is_solid) < constants().perception.min_cut_pixels;
end
