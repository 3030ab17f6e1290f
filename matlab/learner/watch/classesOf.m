function [classes, palette] = classesOf(codes, palette)
% Returns the classes of the pixels of a picture, HxW uint8: see pixelClasses. The palette (see newPalette) remembers them.
%   codes  as from codesIn
  classes = palette.classes(codes + 1);
  is_new = classes == 0;
  if ~any(is_new(:)), return; end
  new = unique(codes(is_new));
  found = arrayfun(@(k) classOf(colorsOfCodes(new(k)), palette), 1:numel(new));
  palette.classes(new + 1) = found;
  classes = palette.classes(codes + 1);
end

function number = classOf(color, palette)
% Returns the class of a color, 1x3.
  classes = pixelClasses();
  same = constants().watching.same_top;
  number = classes.background;
  if any(max(abs(palette.table - color), [], 2) < same), return; end
  number = classes.unknown;
  top = find(max(abs(palette.colors - color), [], 2) < same, 1);
  if ~isempty(top)
    number = classes.first + 2 * (top - 1);
    return
  end
  for k = 1:rows(palette.colors)
    if ~isDarkerShade(color, palette.colors(k, :)), continue; end
    number = classes.first + 2 * k - 1;
    return
  end
end
