function [kinds, palette] = kindsOfKnownSize(codes, palette, kinds, tried, eye)
% Adds kinds and their colors (see learnKinds): those of each area of another color that may be the top of a block of a known
% size, at a height at which such blocks may be. Blocks of these colors never stand by themselves.
%   tried  what previous pictures showed, a map that grows: most does not change
  [classes, palette] = classesOf(codes, palette);
  [found, areas] = unknownAreas(codes, classes == pixelClasses().unknown, tried);
  for k = 1:numel(found)
    color = colorsOfCodes(found(k));
    if ~hasSideBelow(color, areas{k}, codes), continue; end
    sides = knownSizeOf(areas{k}(:, 1), areas{k}(:, 2), kinds, eye);
    if isempty(sides), continue; end
    kinds(end + 1) = struct('color', color, 'size', sides);
    palette = addColor(palette, color);
  end
end

function [found, areas] = unknownAreas(codes, mask, tried)
% Returns the codes of connected areas of one color in a mask that may be tops, 1xN, and the areas, a 1xN cell as from areasIn.
  smallest = constants().perception.min_unknown_object_pixels;
  found = [];
  areas = {};
  pixels = find(mask);
  [shown, begin, which] = unique(codes(pixels), 'first');
  often = accumarray(which(:), 1, [numel(shown), 1]);
  for k = find(often >= smallest)'
    seen = sprintf('%d ', shown(k), often(k), pixels(begin(k)));
    if tried.isKey(seen), continue; end
    tried(seen) = true;
    own = false(size(mask));
    own(pixels(which == k)) = true;
    more = areasIn(own, smallest);
    areas = [areas, more];
    found = [found, repmat(shown(k), 1, numel(more))];
  end
end

function yes = hasSideBelow(color, area, codes)
% Returns true if a darker shade of a color is visible below most of an area.
  lowest = accumarray(area(:, 2), area(:, 1), [size(codes, 2), 1], @max);
  below = find(lowest > 0 & lowest < size(codes, 1));
  shades = colorsOfCodes(codes(sub2ind(size(codes), lowest(below) + 1, below)));
  yes = ~isempty(below) && mean(isDarkerShade(shades, color)) > constants().watching.min_shaded;
end

function found = knownSizeOf(row, column, kinds, eye)
% Returns the known size that a top has at one of the heights at which it may be; [] if it has none.
  c = constants();
  found = [];
  best = c.watching.max_side_error;
  heights = arrayfun(@(it) it.size(3), kinds);
  bottoms = unique((0:c.perception.max_layers - 1)' * heights);
  for kind = kinds
    for bottom = bottoms(:)'
      [x, y, area] = ontoPlane(row, column, eye, bottom + kind.size(3));
      face = fitFace(x, y, area);
      error = max([abs(sort(face.sides, 'descend') ./ kind.size(1:2) - 1), face.misfit]);
      if error >= best || face.isRound, continue; end
      best = error;
      found = kind.size;
    end
  end
end
