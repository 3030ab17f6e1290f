function [kinds, palette] = learnKinds(files, palette, eye)
% Returns the kinds of the blocks that stand by themselves on the table in some pictures, a 1xN struct array with color and
% size, and adds their colors to a palette (see newPalette).
%   files  of the pictures, 1xN cell, the first one of the demonstration first: there no hand holds anything
  kinds = struct('color', {}, 'size', {});
  free = [];  % pixels that showed the background in some picture
  for file = files
    codes = codesIn(file{1});
    [classes, palette] = classesOf(codes, palette);
    is_background = classes == pixelClasses().background;
    [blocks, pixels] = loneBlocks(codes, is_background, eye);
    for k = 1:numel(blocks)
      was_there = isempty(free) || mean(free(pixels{k})) < constants().watching.max_free;
      if ~isNew(blocks(k), kinds, was_there), continue; end
      kinds(end + 1) = struct('color', blocks(k).color, 'size', knownSize(blocks(k).size, kinds, was_there));
      palette = addColor(palette, blocks(k).color);
    end
    if isempty(free), free = is_background; else, free = free | is_background; end
  end
  if isempty(kinds), return; end
  tried = containers.Map();
  for file = files, [kinds, palette] = kindsOfKnownSize(codesIn(file{1}), palette, kinds, tried, eye); end
end

function yes = isNew(block, kinds, was_there)
% Returns true if a block shows a kind that is not known yet. What was put somewhere may be several blocks together, or be in
% a hand, so it does not show another size of a known color.
  alike = kinds(arrayfun(@(it) sameColor(it.color, block.color), kinds));
  is_same = arrayfun(@(it) max(abs(block.size ./ it.size - 1)) < constants().watching.same_kind, alike);
  yes = isempty(alike) || was_there && ~any(is_same);
end

function sides = knownSize(sides, kinds, was_there)
% Returns the size of a block that seems to stand on the table; in a hand it seems larger than it is, in all directions
% alike, and then has the size of a known kind.
  if was_there, return; end
  same = constants().watching.same_kind;
  for it = kinds
    ratios = sides ./ it.size;
    if min(ratios) <= 1 - same || max(ratios) / min(ratios) >= 1 + same, continue; end
    sides = it.size;
    return
  end
end
