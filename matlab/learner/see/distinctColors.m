function colors = distinctColors(colors)
% Merges colors, 3xN, that colorMask cannot distinguish.
  k = 1;
  while k <= size(colors, 2)
    same = max(abs(colors - colors(:, k)), [], 1) < constants().perception.distinct_colors;
    same(1:k) = false;
    colors(:, same) = [];
    k = k + 1;
  end
end
