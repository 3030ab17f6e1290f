function yes = showsSides(view, block, classes, top)
% Returns true if a picture does not contradict the sides of a block at a new place.
%   view     see expectedView
%   classes  of the pixels, HxW
%   top      the class of the pixels of its top
  c = constants();
  corners = toPixel(cornersOf(block), view.eye);
  mask = false(size(classes));
  mask(filled(hull(corners), size(classes))) = true;
  mask(filled(corners(1:4, :), size(classes))) = false;
  bottom = block.position(3) - block.size(3) / 2;
  mask = mask & ~ownedBy(view, blockTops(view.blocks) > bottom + c.perception.on_table);
  shown = classes(mask);
  is_possible = shown == pixelClasses().unknown | shown == top | shown == top + 1;
  yes = isempty(shown) || mean(is_possible) > 1 - c.watching.max_solid_sides;
end
