function blocks = detectBlocks(picture, eye, like, containers, heights, staying)
% Detects the blocks in a picture that look like given ones, at any place and height: a 1xN struct array,
% see newBlock. Partly occluded blocks are not detected.
%   picture    HxWx3, 0 to 1
%   like       blocks or steps
%   containers  in which some may lie, or []
%   heights    as from heightMap: separates tops of one color that meet in the picture; [] or omitted if the
%              eye measures no depth
%   staying    those on whose tops others stand, or a knob; optional
  if nargin < 5, heights = []; end
  if nargin < 6, staying = noBlocks(); end
  blocks = noBlocks();
  table = tableColor(picture);
  is_possible = @(block) isSupported(block, picture, eye, table);
  layouts = like(~cellfun(@isempty, {like.parts}));
  outlined = like(~cellfun(@isempty, {like.outline}));
  like = like(cellfun(@isempty, {like.parts}) & cellfun(@isempty, {like.outline}));
  staying = staying(cellfun(@isempty, {staying.parts}));
  is_ball = strcmp({like.form}, 'ball');
  for color = colorsToDetect(picture, like)
    kinds = blockKinds(like(~is_ball), color');
    bottoms = arrayfun(@(kind) likelyBottoms(like, kind, heights), kinds, 'UniformOutput', false);
    number = labelRegions(colorMask(picture, color'), heights);
    for region = find(accumarray(number(number > 0), 1) >= constants().perception.min_top_pixels)'
      pixels = find(number == region);
      [row, column] = ind2sub(size(number), pixels);
      top = [];
      max_error = constants().perception.max_side_error;
      if ~isempty(heights)
        if ~isLevel(heights(pixels)), continue; end
        top = median(heights(pixels));
        if isCut(row, column, top, heights), max_error = constants().perception.max_cut_side_error; end
      end
      found = fitBlocks(row, column, eye, kinds, containers, is_possible, bottoms, top, max_error);
      % What stays carries others: they hide a part of its top from the start.
      if isempty(found) && ~isempty(top)
        found = fitCovered(row, column, eye, blockKinds(staying, color'), top, heights);
      end
      blocks = [blocks, found];
    end
  end
  if isempty(heights), return; end
  blocks = [blocks, detectBalls(picture, eye, like(is_ball), heights), detectLayouts(picture, eye, layouts, heights)];
  for color = colorsToDetect(picture, outlined)
    blocks = [blocks, detectOutlined(picture, eye, color', blockKinds(outlined, color'), heights)];
  end
end
