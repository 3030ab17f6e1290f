function numbers = carriers(n, objects)
% Returns the numbers of those tracked objects that rest (see newTracker) on which one of them stands, 1xN.
  [blocks, others] = restingBlocks(objects, n);
  numbers = others(arrayfun(@(it) standsOn(objects(n).block, it), blocks) > 0);
end
