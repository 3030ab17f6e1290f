function mask = topOf(view, k)
% Returns the mask, HxW logical, of the pixels that would show the top of a block of a view (see expectedView), by its number.
  mask = view.owner == k & view.isTop;
end
