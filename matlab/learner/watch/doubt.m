function objects = doubt(objects)
% Sets places of tracked objects (see newTracker) aside that were measured by a small part of a top: the next picture may show
% more.
  for n = find(~cellfun(@isempty, {objects.block}) & ~cellfun(@isempty, {objects.placed}))
    if objects(n).seen >= constants().watching.min_seen_edge, continue; end
    others = restingBlocks(objects, n);
    if any(arrayfun(@(it) standsOn(it, objects(n).block), others)), continue; end
    objects(n).doubted = objects(n).placed(end);
    objects(n).placed(end) = [];
    objects(n).block = [];
  end
end
