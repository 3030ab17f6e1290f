function mask = shadeMask(picture, color)
% Returns the mask, HxW logical, of the pixels of a color, 1x3, in any shade: a round surface is bright where it
% faces the light.
  c = constants().balls;
  color = reshape(color, 1, 1, 3);
  fraction = sum(picture .* color, 3) / max(sum(color .^ 2), eps);
  difference = max(abs(picture - fraction .* color), [], 3);
  mask = c.shade(1) < fraction & fraction < c.shade(2) & difference < c.shade_tolerance;
end
