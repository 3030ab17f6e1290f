function codes = codesIn(file)
% Reads a picture as codes 65536 red + 256 green + blue, HxW.
  picture = double(imread(file));
  codes = 65536 * picture(:, :, 1) + 256 * picture(:, :, 2) + picture(:, :, 3);
end
