function colors = colorsOfCodes(codes)
% Returns the colors of N codes (see codesIn), Nx3, 0 to 1.
  codes = codes(:);
  colors = [floor(codes / 65536), mod(floor(codes / 256), 256), mod(codes, 256)] / 255;
end
