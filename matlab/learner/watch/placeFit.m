function tracker = placeFit(tracker, frame, fit, is_first)
% Takes note of a tracked block at a new place: of a fit, see fitVisible.
%   tracker  see newTracker
  objects = tracker.objects;
  began = is_first || beganThere(tracker, fit.block);
  held = find(cellfun(@isempty, {objects.block}) & [objects.kind] == fit.kind);
  is_doubted = ~cellfun(@isempty, {objects(held).doubted});
  doubted = held(is_doubted);
  doubted = doubted(arrayfun(@(n) isSamePlace(objects(n).doubted.block, fit.block), doubted));
  if ~isempty(doubted)
    n = doubted(1);
    frame = objects(n).doubted.frame;
  elseif ~isempty(held) && ~began
    [~, order] = sort(is_doubted);
    n = held(order(1));
  else
    n = numel(objects) + 1;
    objects(n).kind = fit.kind;
    if began, objects(n).start = fit.block; end
    objects(n).placed = struct('frame', {}, 'block', {});
  end
  objects(n).block = fit.block;
  objects(n).seen = fit.seen;
  objects(n).numLooks = 0;
  if ~isempty(doubted) || ~began, objects(n).placed(end + 1) = struct('frame', frame, 'block', fit.block); end
  tracker.objects = objects;
end

function yes = beganThere(tracker, block)
% Returns true if no picture contradicts that a block was at its place from the start.
  yes = ~any(cellfun(@(start) ~isempty(start) && isIn(block, start), {tracker.objects.start}));
  if ~yes, return; end
  top = topOf(expectedView(block, size(tracker.free), tracker.eye), 1);
  yes = mean(tracker.free(top)) < constants().watching.max_free;
end
