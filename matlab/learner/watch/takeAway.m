function objects = takeAway(objects, classes, view, kinds, palette)
% Takes note of the tracked blocks (see newTracker) that are no longer where they rested: what they hid is visible there.
%   classes  of the pixels of a picture, as from classesOf
%   view     of all that rest, see expectedView
  c = constants().watching;
  [~, resting] = restingBlocks(objects);
  for k = 1:numel(resting)
    n = resting(k);
    own = topClass(palette, kinds(objects(n).kind).color);
    below = arrayfun(@(i) topClass(palette, kinds(objects(i).kind).color), carriers(n, objects));
    visible = classes(topOf(view, k));
    is_revealed = ismember(visible, [pixelClasses().background, below(below ~= own)]);
    if numel(visible) > c.min_visible_pixels && mean(is_revealed) > c.max_revealed, objects(n).block = []; end
  end
end
