function mask = explained(view, color)
% Returns the mask, HxW logical, of the pixels at and next to those that would show tops of a color in a view (see
% expectedView).
  own = ownedBy(view, arrayfun(@(it) sameColor(it.color, color), view.blocks)) & view.isTop;
  mask = own;
  mask(1:end - 1, :) = mask(1:end - 1, :) | own(2:end, :);
  mask(2:end, :) = mask(2:end, :) | own(1:end - 1, :);
  mask(:, 1:end - 1) = mask(:, 1:end - 1) | own(:, 2:end);
  mask(:, 2:end) = mask(:, 2:end) | own(:, 1:end - 1);
end
