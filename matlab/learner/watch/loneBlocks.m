function [blocks, pixels] = loneBlocks(codes, is_background, eye)
% Returns the blocks around which only the background is visible, a 1xN struct array, and the numbers of their pixels, a 1xN
% cell. The eye sees three faces of a block or fewer, in one color each; the top is the brightest.
%   codes          as from codesIn
%   is_background  mask, HxW logical
  c = constants();
  blocks = noBlocks();
  pixels = {};
  for area = areasIn(~is_background, c.perception.min_unknown_object_pixels)
    row = area{1}(:, 1);
    column = area{1}(:, 2);
    here = sub2ind(size(codes), row, column);
    [shown, ~, which] = unique(codes(here));
    shown = shown(accumarray(which, 1) > c.watching.max_stray_pixels);
    if numel(shown) < 2 || numel(shown) > c.watching.max_faces || atBorder(row, column, size(codes)), continue; end
    colors = colorsOfCodes(shown);
    [~, top] = max(sum(colors, 2));
    % A color between two that a pixel can have shows as both.
    is_top = max(abs(colors - colors(top, :)), [], 2) < c.watching.same_top;
    if all(is_top) || ~all(isDarkerShade(colors(~is_top, :), colors(top, :))), continue; end
    own = ismember(codes(here), shown(is_top));
    block = measureBySilhouette(colors(top, :), row(own), column(own), numel(row), eye);
    if isempty(block), continue; end
    blocks(end + 1) = block;
    pixels{end + 1} = here;
  end
end
