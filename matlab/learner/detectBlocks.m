function blocks = detectBlocks(picture, eye, like, container)
% Detects the blocks in a picture that look like given ones, at any place and height: a 1xN struct array,
% see noBlocks. Partly occluded blocks are not detected.
%   picture    HxWx3, 0 to 1
%   like       blocks or steps
%   container  in which some may lie, or []
  blocks = noBlocks();
  table = tableColor(picture);
  is_possible = @(block) isSupported(block, picture, eye, table);
  for color = colorsToDetect(picture, like)
    kinds = blockKinds(like, color');
    number = labelRegions(colorMask(picture, color'));
    for region = 1:max(number(:))
      [row, column] = find(number == region);
      if numel(row) < constants().perception.min_top_pixels, continue; end
      blocks = [blocks, fitBlocks(row, column, eye, kinds, container, is_possible)];
    end
  end
end
