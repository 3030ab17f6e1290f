function object = refine(object, classes, viewWithout, kinds, palette)
% Measures the place of a tracked object (see newTracker) again if it was just taken, or if more of its top may be visible.
%   classes      of the pixels of a picture, as from classesOf
%   viewWithout  function: returns the view (see expectedView) of the other blocks that rest
  c = constants().watching;
  object.numLooks = object.numLooks + 1;
  if object.numLooks > c.num_looks && object.seen > c.well_seen, return; end
  view = viewWithout();
  block = object.block;
  top = topClass(palette, kinds(object.kind).color);
  own = topOf(expectedView(block, size(classes), view.eye), 1);
  pieces = areasIn(classes == top & ~explained(view, kinds(object.kind).color), c.min_piece_pixels);
  is_own = cellfun(@(area) any(own(sub2ind(size(own), area(:, 1), area(:, 2)))), pieces);
  pixels = vertcat(pieces{logical(is_own)});
  if isempty(pixels), return; end
  mask = solid(view, classes, top, block.position(3) + block.size(3) / 2);
  bottom = block.position(3) - block.size(3) / 2;
  fit = fitVisible(pixels(:, 1), pixels(:, 2), kinds, object.kind, bottom, mask, view.eye);
  if isempty(fit) || fit.seen < c.well_seen * object.seen, return; end
  is_surer = fit.certainty == 2 && object.seen < c.well_seen;
  if ~is_surer && norm(fit.block.position - block.position) > c.max_refinement, return; end
  object.block = fit.block;
  object.seen = fit.seen;
  if isempty(object.placed), object.start = fit.block; else, object.placed(end).block = fit.block; end
end
