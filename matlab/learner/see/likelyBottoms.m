function bottoms = likelyBottoms(like, kind, heights)
% Returns the heights at which the bottom of a block of some kind may be expected, 1xN [units]: on the
% table, where such blocks are or must go, and, without measured heights, on whole layers.
  layers = 0;
  if isempty(heights), layers = 0:constants().perception.max_layers - 1; end
  same = like(arrayfun(@(it) isSameKind(kind, it), like));
  found = arrayfun(@(it) it.position(3) - it.size(3) / 2, same);
  bottoms = unique(round(100 * [layers, found]) / 100);
end
