function palette = newPalette(codes)
% Returns a palette, which tells what the pixels of the pictures of a demonstration may show by their colors, of which faces
% in these pictures have one each.
%   codes    the first picture, as from codesIn
%   table    colors of the table and of what is beyond it, 2x3
%   colors   those of known tops, Nx3
%   classes  of all codes, from 0 on, see pixelClasses; 0 where not determined yet
  shown = colorsOfCodes(codes);
  palette = struct('table', [tableColor(reshape(shown, [size(codes), 3])); 0, 0, 0], 'colors', zeros(0, 3), ...
                   'classes', zeros(2 ^ 24, 1, 'uint8'));
end
