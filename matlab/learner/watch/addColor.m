function palette = addColor(palette, color)
% Adds the color of a top, 1x3, to a palette (see newPalette), unless it is known.
  if any(max(abs(palette.colors - color), [], 2) < constants().watching.same_top), return; end
  palette.colors(end + 1, :) = color;
  palette.classes(:) = 0;
end
