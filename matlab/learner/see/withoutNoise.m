function picture = withoutNoise(picture, noise, count)
% Returns the mean of some pictures of the same, HxWx3 from 0 to 1, without the noise that it still has: each face has
% one flat color.
%   noise  of each of them, as from noiseOf
%   count  number of the pictures
  c = constants().pictures;
  for k = 1:c.num_evenings, picture = evened(picture, c.num_deviations * noise / sqrt(count)); end
  codes = reshape(round(255 * picture), [], 3) * [65536; 256; 1];
  [found, ~, which] = unique(codes);
  colors = [floor(found / 65536), mod(floor(found / 256), 256), mod(found, 256)] / 255;
  colors = round(255 * unsaturated(joined(colors, accumarray(which(:), 1), c), noise)) / 255;
  picture = reshape(colors(which, :), size(picture));
end

function picture = evened(picture, tolerance)
% Gives each pixel the mean color of those around it that have about its color, so that edges stay sharp.
  [height, width, ~] = size(picture);
  wide = picture([1, 1:end, end], [1, 1:end, end], :);
  total = zeros(size(picture));
  count = zeros(height, width);
  for right = 0:2
    for down = 0:2
      other = wide(down + (1:height), right + (1:width), :);
      is_alike = max(abs(other - picture), [], 3) < tolerance;
      total = total + other .* is_alike;
      count = count + is_alike;
    end
  end
  picture = total ./ count;
end

function colors = joined(colors, counts, c)
% Replaces colors that differ by noise only, Nx3, by their mean: those around the most frequent ones.
%   counts  Nx1, of pixels that have each of them
  is_free = true(size(counts));
  [counts_down, order] = sort(counts, 'descend');
  for k = order(counts_down >= c.min_even_pixels)'
    if ~is_free(k), continue; end
    near = is_free & max(abs(colors - colors(k, :)), [], 2) < c.same_color;
    colors(near, :) = repmat(counts(near)' * colors(near, :) / sum(counts(near)), sum(near), 1);
    is_free = is_free & ~near;
  end
end

function values = unsaturated(means, noise)
% Returns the values, from 0 to 1, that have some means with a noise that is cut off at 0 and at 1.
  values = means;
  if noise == 0, return; end
  whole = (0:255) / 255;
  cut_off = @(z) exp(-z .^ 2 / 2) / sqrt(2 * pi) - z .* erfc(z / sqrt(2)) / 2;
  seen = whole + noise * (cut_off(whole / noise) - cut_off((1 - whole) / noise));
  values = interp1(seen, whole, min(max(means, seen(1)), seen(end)));
end
