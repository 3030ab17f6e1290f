function block = fitCovered(row, column, eye, kinds, top, heights)
% Fits a block of one of some kinds to the visible part of a top face: the smallest rectangle around it has the
% sides of the block, and what is missing within it is hidden by something higher. A 1x0 struct array if nothing
% fits.
%   row, column  pixels, Nx1
%   kinds        as from blockKinds
%   top          measured height of the face [units]
%   heights      as from heightMap
  block = noBlocks();
  kinds = kinds(~arrayfun(@isRound, kinds));
  if isempty(kinds), return; end
  [x, y, area] = ontoPlane(row, column, eye, top);
  face = smallestRectangle(x, y, sqrt(median(area)));
  for kind = kinds
    has_sides = max(abs(face.sides ./ kind.size(1:2) - 1)) < constants().perception.max_cut_side_error;
    if has_sides && isMissingHidden(row, column, face, top, eye, heights)
      block = newBlock(kind.color, kind.size, [face.center, top - kind.size(3) / 2], face.yaw);
      return
    end
  end
end

function yes = isMissingHidden(row, column, face, top, eye, heights)
% Returns true if the eye sees, almost everywhere in a rectangle, its visible part or something higher.
  c = constants().perception;
  is_seen = heights > top + c.height_step;
  is_seen(sub2ind(size(heights), row, column)) = true;
  fractions = linspace(-0.48, 0.48, c.points_per_side);
  [a, b] = ndgrid(fractions * face.sides(1), fractions * face.sides(2));
  turn = [cos(face.yaw), sin(face.yaw); -sin(face.yaw), cos(face.yaw)];
  points = face.center + [a(:), b(:)] * turn;
  pixels = pixelAt([points, repmat(top, rows(points), 1)], eye);
  yes = all(all(pixels >= 1 & pixels <= [size(heights, 2), size(heights, 1)])) && ...
        mean(is_seen(sub2ind(size(heights), pixels(:, 2), pixels(:, 1)))) > c.min_explained;
end
