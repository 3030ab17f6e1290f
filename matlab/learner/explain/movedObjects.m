function moved = movedObjects(demo)
% Returns the numbers of the objects that hands moved, in the order of their last release.
  last = zeros(1, numel(demo.ids));
  last(demo.placed) = 1:numel(demo.placed);
  moved = find(last > 0);
  if isempty(moved), notUnderstood('in this demonstration no hand moved anything'); end
  [~, order] = sort(last(moved));
  moved = moved(order);
end
