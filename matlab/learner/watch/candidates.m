function found = candidates(classes, view, kinds, palette)
% Returns the fits (see fitVisible) of blocks at new places in a picture, a 1xN struct array.
%   classes  of its pixels, HxW
%   view     of the blocks that rest, see expectedView
%   kinds    see learnKinds
  c = constants();
  found = noFits();
  tops = arrayfun(@(it) topClass(palette, it.color), kinds);
  for top = unique(tops)
    alike = find(tops == top);
    pieces = areasIn(classes == top & ~explained(view, kinds(alike(1)).color), c.watching.min_piece_pixels);
    areas = pieces(cellfun(@rows, pieces) >= c.perception.min_top_pixels);
    if numel(pieces) > 1 && numel(pieces) <= c.watching.max_pieces  % something may hide the middle
      areas{end + 1} = vertcat(pieces{:});
    end
    for area = areas
      fits = fitsOf(area{1}(:, 1), area{1}(:, 2), top, classes, view, kinds, alike);
      found = [found, bestFit(fits)];
    end
  end
end

function fits = fitsOf(row, column, top, classes, view, kinds, alike)
% Returns the fits of some kinds to the pixels of a top that are possible among the blocks that rest.
%   top    the class of the pixels
%   alike  numbers of the kinds
  fits = noFits();
  for bottom = unique(round(1000 * [0; blockTops(view.blocks)]') / 1000)
    for k = alike
      mask = solid(view, classes, top, bottom + kinds(k).size(3));
      fit = fitVisible(row, column, kinds, k, bottom, mask, view.eye);
      if isempty(fit), continue; end
      stands = bottom == 0 || any(arrayfun(@(it) standsOn(fit.block, it), view.blocks));
      is_in = any(arrayfun(@(it) isIn(fit.block, it), view.blocks));
      if stands && ~is_in && showsSides(view, fit.block, classes, top), fits(end + 1) = fit; end
    end
  end
end
