function tops = segmentTopFaces(picture, table, heights)
% Segments the flat areas of a picture that may be tops of blocks: those at one height above the table, or,
% without heights, those that are not, like the sides of blocks, below a brighter area of the same hue.
%   table    color of the table, 1x3
%   heights  as from heightMap; [] or omitted if the eye measures no depth
%   tops     1xN struct array with color, and row and column of each pixel
  if nargin < 3, heights = []; end
  tops = struct('color', {}, 'row', {}, 'column', {});
  smallest = constants().perception.min_unknown_object_pixels;
  height = size(picture, 1);
  codes = round(255 * picture(:, :, 1)) * 65536 + round(255 * picture(:, :, 2)) * 256 + ...
          round(255 * picture(:, :, 3));
  codes(colorMask(picture, table)) = 0;
  [~, ~, which] = unique(codes);
  count = accumarray(which, 1);
  codes(count(which) < smallest) = 0;
  number = labelRegions(codes, heights);
  [sorted, pixels] = sort(number(:));
  ends = [find(diff(sorted)); numel(sorted)];
  for i = find(diff(ends) >= smallest)'
    inside = pixels(ends(i) + 1:ends(i + 1));
    if codes(inside(1)) == 0, continue; end
    k = number(inside(1));
    above = inside(mod(inside - 1, height) > 0) - 1;
    above = mode([0; codes(above(number(above) ~= k))]);
    color = colorOfCode(codes(inside(1)));
    if isempty(heights)
      is_side = isDarkerShade(color, colorOfCode(above));
    else
      is_side = ~isLevel(heights(inside));
    end
    if is_side, continue; end
    [row, column] = ind2sub(size(codes), inside);
    tops(end + 1) = struct('color', color, 'row', row, 'column', column);
  end
end

function yes = isLevel(heights)
% Returns true if the heights of some pixels, Nx1, are those of one level area above the table.
  c = constants().perception;
  ordered = sort(heights);
  at = ordered(1 + floor([0.1, 0.5, 0.9] * (numel(ordered) - 1)));
  yes = at(2) > c.on_table && at(3) - at(1) < c.height_step;
end

function color = colorOfCode(code)
% Returns the color, 1x3, of a number 65536 red + 256 green + blue, each from 0 to 255.
  color = [floor(code / 65536), mod(floor(code / 256), 256), mod(code, 256)] / 255;
end
