function colors = colorsToDetect(picture, steps)
% Returns the colors to detect, 3xN: those of the steps and, if the color of some step does not matter,
% every frequent color of the picture.
  colors = vertcat(steps.color)';
  if any(cellfun(@isempty, {steps.color}))
    colors = [colors, frequentColors(picture, constants().perception.frequent_color_pixels)];
  end
  colors = distinctColors(colors);
end
