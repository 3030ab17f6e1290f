function [before, after, changed] = changes(demo, first, last, what)
% Returns the last picture of a demonstration before a frame, the last one before a later frame, and the mask of the pixels
% that differ.
%   what  it shows, for messages
  frames = pictureFrames(demo);
  earlier = frames(frames < first);
  later = frames(frames >= first & frames < last);
  if isempty(earlier) || isempty(later), notUnderstood('no picture of the demonstration shows what was done to %s', what); end
  before = readPicture(demo, earlier(end));
  after = readPicture(demo, later(end));
  changed = largeRegions(max(abs(after - before), [], 3) > constants().presses.min_change) > 0;
  if ~any(changed(:)), notUnderstood('no picture of the demonstration shows what was changed at %s', what); end
end
