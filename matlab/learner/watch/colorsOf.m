function colors = colorsOf(picture, pixels)
% Returns the colors of some pixels of a picture, HxWx3, by their numbers: Nx3.
  stride = numel(picture) / 3;
  colors = [picture(pixels), picture(pixels + stride), picture(pixels + 2 * stride)];
end
