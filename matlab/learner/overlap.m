function yes = overlap(one, many)
% Returns true for each of many rectangles, Nx5 (see footprint), that overlaps with one, 1x5: Nx1 logical.
% Separating axes: two rectangles are apart if there is a gap between them in the direction of a side.
  yes = true(size(many, 1), 1);
  if isempty(yes), return; end
  % The offsets of the centers in the frame of the first rectangle, and in those of the others.
  angle = many(:, 5) - one(5);
  c = abs(cos(angle)) / 2;
  s = abs(sin(angle)) / 2;
  offset = many(:, 1:2) - one(1:2);
  own = rotated(offset, one(5));
  theirs = rotated(offset, many(:, 5));
  yes = abs(own(:, 1)) < one(3) / 2 + many(:, 3) .* c + many(:, 4) .* s & ...
        abs(own(:, 2)) < one(4) / 2 + many(:, 3) .* s + many(:, 4) .* c & ...
        abs(theirs(:, 1)) < many(:, 3) / 2 + one(3) * c + one(4) * s & ...
        abs(theirs(:, 2)) < many(:, 4) / 2 + one(3) * s + one(4) * c;
end

function vectors = rotated(vectors, yaw)
% Returns vectors, Nx2, in a frame with a yaw [rad].
  vectors = [vectors(:, 1) .* cos(yaw) + vectors(:, 2) .* sin(yaw), ...
             vectors(:, 2) .* cos(yaw) - vectors(:, 1) .* sin(yaw)];
end
