function yes = movesAlong(color, pose, frames, height, eye, pictures)
% Returns true if a picture shows a color also at the top of an object elsewhere.
%   pose      of the object where its top has the color, 1x6 [units, degrees]
%   frames    rows of frame and pose, Mx7
%   pictures  of these frames, a map
  yes = true;
  is_elsewhere = sqrt(sum((frames(:, 2:4) - pose(1:3)) .^ 2, 2)) > constants().outlines.min_distance;
  for row = frames(is_elsewhere, :)'
    there = colorAt(pictures(row(1)), eye, row(2:4)' + [0, 0, height / 2]);
    if ~isempty(there) && sameColor(color, there), return; end
  end
  yes = false;
end
