function class_number = topClass(palette, color)
% Returns the class of the tops of a color, 1x3: see pixelClasses.
  [~, k] = min(max(abs(palette.colors - color), [], 2));
  class_number = pixelClasses().first + 2 * (k - 1);
end
