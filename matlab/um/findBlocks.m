function blocks = findBlocks(picture, eye, steps, container)
% The blocks in a picture that look like one of the steps', wherever they are: see noBlocks. A block of
% which something hides a part is not found.
%   container  in which some may lie, or []
  blocks = noBlocks();
  for color = colorsIn(picture, steps)
    kinds = kindsOf(steps, color');
    number = labelRegions(isColor(picture, color'));
    for region = 1:max(number(:))
      [row, column] = find(number == region);
      if numel(row) < 60, continue; end
      blocks = [blocks, fitBlock(row, column, eye, kinds, container)];
    end
  end
end
