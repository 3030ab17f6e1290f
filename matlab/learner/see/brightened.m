function colors = brightened(colors, gains)
% Returns colors, Nx3, or a picture, HxWx3, in a light with some gains, 1x3: see gainsBetween.
  if ndims(colors) == 3, gains = reshape(gains, 1, 1, 3); end
  colors = min(colors .* gains, 1);
end
