function word = wordOf(color)
% Returns the word for the known color that is closest to one, 1x3.
  words = {'Red', 'Green', 'Blue', 'Yellow', 'Cyan', 'Magenta', 'Orange', 'Brown', 'White', 'Gray', 'Black'};
  colors = [1 0 0; 0 1 0; 0 0 1; 1 1 0; 0 1 1; 1 0 1; 1 0.5 0; 0.25 0.16 0.1; 1 1 1; 0.5 0.5 0.5; 0 0 0];
  [~, nearest] = min(sum((colors - color) .^ 2, 2));
  word = words{nearest};
end
