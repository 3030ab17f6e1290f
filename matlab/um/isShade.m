function yes = isShade(color, bright)
% Whether a color, 1x3, is a darker one of the same hue: that of a side of a block with a bright top.
  share = sum(color .* bright) / max(sum(bright .^ 2), eps);
  yes = share > 0.3 && share < 0.95 && max(abs(color - share * bright)) < 0.02;
end
