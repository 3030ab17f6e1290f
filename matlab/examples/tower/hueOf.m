function hue = hueOf(color)
% The hue (0 to 1) of a color by its name.
  names = {'red', 'orange', 'yellow', 'green', 'cyan', 'blue', 'magenta'};
  hues = [0, 31, 60, 120, 180, 240, 300] / 360;
  i = find(strcmp(names, color));
  if isempty(i), error('a block of color "%s" cannot be found by its hue', color); end
  hue = hues(i);
end
