function tops = segmentTopFaces(picture, table, heights)
% Segments the flat areas of a picture that may be tops of blocks: those at one height above the table, or,
% without heights, those that are not, like the sides of blocks, below a brighter area of the same hue.
%   table    color of the table, 1x3
%   heights  as from heightMap; [] or omitted if the eye measures no depth
%   tops     1xN struct array with color, and row and column of each pixel
  if nargin < 3, heights = []; end
  tops = struct('color', {}, 'row', {}, 'column', {});
  smallest = constants().perception.min_unknown_object_pixels;
  if isempty(heights)
    tops = withoutHeights(picture, table, smallest);
    return
  end
  for color = frequentColors(picture, smallest)
    if colorMask(reshape(color, 1, 1, 3), table), continue; end
    number = labelRegions(colorMask(picture, color'), heights);
    count = accumarray(number(number > 0), 1);
    for region = find(count >= smallest)'
      inside = find(number == region);
      if ~isLevel(heights(inside)), continue; end
      [row, column] = ind2sub(size(number), inside);
      tops(end + 1) = struct('color', color', 'row', row, 'column', column);
    end
  end
end

function tops = withoutHeights(picture, table, smallest)
% Exact colors distinguish the tops from the sides.
  tops = struct('color', {}, 'row', {}, 'column', {});
  height = size(picture, 1);
  codes = round(255 * picture(:, :, 1)) * 65536 + round(255 * picture(:, :, 2)) * 256 + ...
          round(255 * picture(:, :, 3));
  codes(colorMask(picture, table)) = 0;
  [~, ~, which] = unique(codes);
  count = accumarray(which, 1);
  codes(count(which) < smallest) = 0;
  number = labelRegions(codes);
  [sorted, pixels] = sort(number(:));
  ends = [find(diff(sorted)); numel(sorted)];
  for i = find(diff(ends) >= smallest)'
    inside = pixels(ends(i) + 1:ends(i + 1));
    k = number(inside(1));
    above = inside(mod(inside - 1, height) > 0) - 1;
    above = mode([0; codes(above(number(above) ~= k))]);
    color = colorOfCode(codes(inside(1)));
    if isDarkerShade(color, colorOfCode(above)), continue; end
    [row, column] = ind2sub(size(codes), inside);
    tops(end + 1) = struct('color', color, 'row', row, 'column', column);
  end
end

function color = colorOfCode(code)
% Returns the color, 1x3, of a number 65536 red + 256 green + blue, each from 0 to 255.
  color = [floor(code / 65536), mod(floor(code / 256), 256), mod(code, 256)] / 255;
end
