function seen = recognizeBlocks(tops, eye, kinds, cache)
% Returns the blocks that have these tops, with the number of visible pixels of each. A block of a color
% that no known kind has may have the size of any kind.
%   cache  results for tops of previous pictures: most do not change
  seen = noBlocks();
  [seen.pixels] = deal(0);
  for top = tops
    key = sprintf('%g ', top.color, numel(top.row), sum(top.row), sum(top.column), top.row(1), top.column(1));
    if ~cache.isKey(key)
      of = kinds(arrayfun(@(kind) sameColor(kind.color, top.color), kinds));
      if isempty(of)
        of = kinds;
        [of.color] = deal(top.color);
      end
      layers = repmat({0:constants().perception.max_layers - 1}, 1, numel(of));
      found = fitBlocks(top.row, top.column, eye, of, [], @(block) true, layers);
      [found.pixels] = deal(numel(top.row));
      cache(key) = found;
    end
    seen = [seen, cache(key)];
  end
end
