function colors = frequentColors(picture, min_pixels)
% Returns the colors that more than a few pixels of a picture have, 3xN.
  flat = reshape(round(picture * 255), [], 3);
  bright = constants().perception.bright_of_255;
  [found, ~, which] = unique(flat(all(flat > 0, 2) | any(flat > bright, 2), :), 'rows');
  many = accumarray(which, 1) > min_pixels;
  colors = distinctColors(found(many, :)' / 255);
end
