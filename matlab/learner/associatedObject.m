function k = associatedObject(block, objects, is_matched, is_table)
% Associates a block at a new place with an object; [] for one that was never seen. Covered objects cannot
% have moved. Objects whose old place shows the table come first, then the closest, which may be occluded.
  free = find(~is_matched & arrayfun(@(other) isSameObject(other, block, Inf), objects));
  free = free(arrayfun(@(k) ~isCovered(objects(k), objects), free));
  gone = free(arrayfun(@(k) is_table(objects(k)), free));
  if ~isempty(gone), free = gone; end
  [~, nearest] = min(arrayfun(@(k) norm(objects(k).position - block.position), free));
  k = free(nearest);
end
