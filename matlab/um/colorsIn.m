function colors = colorsIn(picture, steps)
% The colors to look for, 3xN: those of the steps; and if for some step color does not matter, every
% color that is in the picture.
  colors = vertcat(steps.color)';
  if any(cellfun(@isempty, {steps.color}))
    flat = reshape(round(picture * 255), [], 3);
    see = constants().see;
    [found, ~, which] = unique(flat(all(flat > 0, 2) | any(flat > see.bright_of_255, 2), :), 'rows');
    many = accumarray(which, 1) > see.frequent_color_pixels;
    colors = [colors, found(many, :)' / 255];
  end
  % Colors that isColor cannot tell apart are one.
  k = 1;
  while k <= size(colors, 2)
    same = max(abs(colors - colors(:, k)), [], 1) < constants().see.different_colors;
    same(1:k) = false;
    colors(:, same) = [];
    k = k + 1;
  end
end
