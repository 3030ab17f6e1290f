function blocks = findBlocks(picture, eye, like, container)
% The blocks in a picture that look like some others, wherever they are: see noBlocks. A block of which
% something hides a part is not found.
%   like       blocks or steps
%   container  in which some may lie, or []
  blocks = noBlocks();
  table = tableColor(picture);
  is_possible = @(block) isHeldUp(block, picture, eye, table);
  for color = colorsIn(picture, like)
    kinds = kindsOf(like, color');
    number = labelRegions(isColor(picture, color'));
    for region = 1:max(number(:))
      [row, column] = find(number == region);
      if numel(row) < constants().see.top_pixels, continue; end
      blocks = [blocks, fitBlocks(row, column, eye, kinds, container, is_possible)];
    end
  end
end
