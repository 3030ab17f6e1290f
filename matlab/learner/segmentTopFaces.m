function tops = segmentTopFaces(picture, table)
% Segments the flat areas of a picture that may be tops of blocks: those that are not, like the sides of
% blocks, below a brighter area of the same hue.
%   table  color of the table, 1x3
%   tops   1xN struct array with color, and row and column of each pixel
  tops = struct('color', {}, 'row', {}, 'column', {});
  smallest = constants().perception.min_unknown_object_pixels;
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
