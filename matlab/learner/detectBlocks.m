function blocks = detectBlocks(picture, eye, like, container, heights)
% Detects the blocks in a picture that look like given ones, at any place and height: a 1xN struct array,
% see noBlocks. Partly occluded blocks are not detected.
%   picture    HxWx3, 0 to 1
%   like       blocks or steps
%   container  in which some may lie, or []
%   heights    as from heightMap: separates tops of one color that meet in the picture; [] or omitted if the
%              eye measures no depth
  if nargin < 5, heights = []; end
  blocks = noBlocks();
  table = tableColor(picture);
  is_possible = @(block) isSupported(block, picture, eye, table);
  for color = colorsToDetect(picture, like)
    kinds = blockKinds(like, color');
    bottoms = arrayfun(@(kind) likelyBottoms(like, kind, heights), kinds, 'UniformOutput', false);
    number = labelRegions(colorMask(picture, color'), heights);
    for region = 1:max(number(:))
      pixels = find(number == region);
      if numel(pixels) < constants().perception.min_top_pixels, continue; end
      [row, column] = ind2sub(size(number), pixels);
      top = [];
      max_error = constants().perception.max_side_error;
      if ~isempty(heights)
        if ~isLevel(heights(pixels)), continue; end
        top = median(heights(pixels));
        if isCut(row, column, top, heights), max_error = constants().perception.max_cut_side_error; end
      end
      found = fitBlocks(row, column, eye, kinds, container, is_possible, bottoms, top, max_error);
      blocks = [blocks, found];
    end
  end
end
