function tracker = trackPicture(tracker, frame, classes, is_still)
% Tracks the blocks of a demonstration (see newTracker) in the next picture.
%   classes   of its pixels, as from classesOf
%   is_still  whether the scene was still
  is_first = isempty(tracker.free);
  is_settled = is_first || is_still || tracker.wasStill;
  tracker.wasStill = is_still;
  if is_first, tracker.free = false(size(classes)); end
  tracker = withView(tracker);
  tracker.objects = takeAway(tracker.objects, classes, tracker.view, tracker.kinds, tracker.palette);
  tracker.objects = doubt(tracker.objects);
  before = tracker.before;
  tracker.before = noBlocks();
  while true
    tracker = withView(tracker);
    found = candidates(classes, tracker.view, tracker.kinds, tracker.palette);
    if ~is_still && ~is_first
      has_rested = logical(arrayfun(@(fit) any(arrayfun(@(it) isSamePlace(fit.block, it), before)), found));
      for fit = found(~has_rested), tracker.before(end + 1) = fit.block; end
      found = found(has_rested);
    end
    if isempty(found), break; end
    % Of those that are seen as well, the first one: sums differ by their rounding.
    [~, best] = max(round(1e6 * [found.seen]));
    tracker = placeFit(tracker, frame, found(best), is_first);
  end
  tracker.objects = believe(tracker.objects);
  if is_settled
    [~, resting] = restingBlocks(tracker.objects);
    for n = resting
      viewWithout = @() expectedView(restingBlocks(tracker.objects, n), size(classes), tracker.eye);
      tracker.objects(n) = refine(tracker.objects(n), classes, viewWithout, tracker.kinds, tracker.palette);
    end
  end
  tracker.free = tracker.free | classes == pixelClasses().background;
end

function tracker = withView(tracker)
% Updates what the eye would see of all blocks that rest.
  blocks = restingBlocks(tracker.objects);
  if ~isempty(tracker.view) && isequal(placesOf(blocks), placesOf(tracker.view.blocks)), return; end
  tracker.view = expectedView(blocks, size(tracker.free), tracker.eye);
end

function places = placesOf(blocks)
% Returns the places of blocks and their yaws, Nx4.
  places = [vertcat(blocks.position), vertcat(blocks.yaw)];
end
