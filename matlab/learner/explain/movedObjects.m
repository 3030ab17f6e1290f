function moved = movedObjects(demo)
% Returns the numbers of the objects that hands moved and do not hold at the end, in the order of their last release; none where
% they only pressed switches.
  last = zeros(1, numel(demo.ids));
  last(demo.placed) = 1:numel(demo.placed);
  moved = find(last > 0);
  if isfield(demo, 'held'), moved = setdiff(moved, demo.held); end
  is_press = isfield(demo, 'events') && any(ismember({demo.events.word}, {'trigger', 'press'}));
  if isempty(moved) && ~is_press, notUnderstood('in this demonstration no hand moved anything to a place'); end
  [~, order] = sort(last(moved));
  moved = moved(order);
end
