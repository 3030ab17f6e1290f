function colors = colorsToDetect(picture, steps)
% Returns the colors to detect, 3xN: those of the steps and, if the color of some step does not matter,
% every frequent color of the picture.
  colors = vertcat(steps.color)';
  if any(cellfun(@isempty, {steps.color}))
    flat = reshape(round(picture * 255), [], 3);
    see = constants().perception;
    [found, ~, which] = unique(flat(all(flat > 0, 2) | any(flat > see.bright_of_255, 2), :), 'rows');
    many = accumarray(which, 1) > see.frequent_color_pixels;
    colors = [colors, found(many, :)' / 255];
  end
  % Merge colors that colorMask cannot distinguish.
  k = 1;
  while k <= size(colors, 2)
    same = max(abs(colors - colors(:, k)), [], 1) < constants().perception.distinct_colors;
    same(1:k) = false;
    colors(:, same) = [];
    k = k + 1;
  end
end
