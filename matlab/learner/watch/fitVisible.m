function fit = fitVisible(row, column, kinds, k, bottom, solid, eye)
% Fits a block of a kind (see learnKinds), whose bottom is at some height, to the visible part of its top. Returns a 1x0
% struct array if no place fits, or more than one.
%   row, column    pixels that show its top, Nx1
%   k              number of the kind
%   solid          mask, HxW logical, of pixels that show what its top would hide, like the table
%   fit.block      that may have a top of these pixels
%   fit.kind       its number
%   fit.seen       area of the pixels, relative to that of its top: about 1 if nothing hides any of them
%   fit.certainty  2 if its top is entirely visible, 1 if it is so in both directions, else 0
  c = constants().watching;
  fit = noFits();
  kind = kinds(k);
  top = bottom + kind.size(3);
  [x, y, area] = ontoPlane(row, column, eye, top);
  seen = sum(area) / prod(kind.size(1:2));
  if seen <= c.min_top_seen || seen >= 1 / (1 - c.max_side_error) ^ 2, return; end
  certainty = 2;
  if isWhole(row, column, solid)
    faces = wholeFaces(fitFace(x, y, area), kind.size);
  else
    outline = endsOfRows(row, column);
    around = smallestRectangle(x(outline), y(outline), sqrt(median(area)));
    certainty = double(max(abs(kind.size(1:2) - around.sides)) < c.max_missing);
    faces = facesWith(around, kind.size, seen);
    faces = faces(arrayfun(@(it) isFaceFree(it, top, solid, eye), faces));
  end
  if numel(faces) ~= 1, return; end
  block = newBlock(kind.color, kind.size, [faces.center, top - kind.size(3) / 2], faces.yaw);
  fit(1) = struct('block', block, 'kind', k, 'seen', seen, 'certainty', certainty);
end
