function mask = solid(view, classes, top, height)
% Returns the mask, HxW logical, of the pixels that show what a top at a height would hide: the background, sides of its own
% color, and lower blocks of a view (see expectedView).
%   classes  of the pixels, HxW
%   top      the class of the pixels of that top
  background = pixelClasses().background;
  is_lower = ownedBy(view, blockTops(view.blocks) < height - constants().perception.on_table);
  is_other = classes ~= top & classes > background;
  mask = classes == background | classes == top + 1 | is_lower & is_other;
end
