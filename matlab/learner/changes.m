function [before, after, changed] = changes(demo, first, last, what)
% Returns the last picture of a demonstration before a frame, the last one before a later frame, and the mask of the pixels
% that differ.
%   what  it shows, for messages
  c = constants().presses;
  frames = pictureFrames(demo);
  earlier = frames(frames < first);
  later = frames(frames >= first & frames < last);
  if isempty(earlier) || isempty(later), error('no picture of the demonstration shows what was done to %s', what); end
  before = readPicture(demo, earlier(end));
  after = readPicture(demo, later(end));
  number = labelRegions(max(abs(after - before), [], 3) > c.min_change);
  % Thin rims change where something still moves a little.
  is_large = [false; accumarray(number(number > 0), 1) >= c.min_changed_pixels];
  changed = is_large(number + 1);
  if ~any(changed(:)), error('no picture of the demonstration shows what was changed at %s', what); end
end
