function name = colorName(color)
% Returns an English word for a color, 1x3, for messages.
  names = {'red', 'green', 'blue', 'yellow', 'cyan', 'magenta', 'orange', 'brown', 'white', 'gray', 'black'};
  colors = [1 0 0; 0 1 0; 0 0 1; 1 1 0; 0 1 1; 1 0 1; 1 0.5 0; 0.25 0.16 0.1; 1 1 1; 0.5 0.5 0.5; 0 0 0];
  [~, nearest] = min(sum((colors - color) .^ 2, 2));
  name = names{nearest};
end
