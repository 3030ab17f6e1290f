function yes = isDarkerShade(color, bright)
% Returns true if a color, 1x3, is a darker shade of the same hue: that of a side of a block with a bright
% top.
  c = constants().perception;
  fraction = sum(color .* bright) / max(sum(bright .^ 2), eps);
  yes = fraction > c.shade(1) && fraction < c.shade(2) && ...
        max(abs(color - fraction * bright)) < c.shade_tolerance;
end
