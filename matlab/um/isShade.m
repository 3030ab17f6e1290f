function yes = isShade(color, bright)
% Whether a color, 1x3, is a darker one of the same hue: that of a side of a block with a bright top.
  c = constants().see;
  share = sum(color .* bright) / max(sum(bright .^ 2), eps);
  yes = share > c.shade(1) && share < c.shade(2) && max(abs(color - share * bright)) < c.shade_tolerance;
end
