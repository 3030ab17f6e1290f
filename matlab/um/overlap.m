function yes = overlap(one, many)
% Whether a rectangle, 1x5 (see footprint), has points in common with each of many, Nx5: Nx1 logical. Two
% rectangles are apart if, in the direction of one of their sides, there is a gap between them.
  yes = true(size(many, 1), 1);
  if isempty(yes), return; end
  % Their sides, and the ways between the centers, in the frame of the first one, then in theirs.
  turn = many(:, 5) - one(5);
  c = abs(cos(turn)) / 2;
  s = abs(sin(turn)) / 2;
  gap = many(:, 1:2) - one(1:2);
  own = turned(gap, one(5));
  theirs = turned(gap, many(:, 5));
  yes = abs(own(:, 1)) < one(3) / 2 + many(:, 3) .* c + many(:, 4) .* s & ...
        abs(own(:, 2)) < one(4) / 2 + many(:, 3) .* s + many(:, 4) .* c & ...
        abs(theirs(:, 1)) < many(:, 3) / 2 + one(3) * c + one(4) * s & ...
        abs(theirs(:, 2)) < many(:, 4) / 2 + one(3) * s + one(4) * c;
end

function ways = turned(ways, yaw)
% Ways, Nx2, as seen from something that is turned by yaw.
  ways = [ways(:, 1) .* cos(yaw) + ways(:, 2) .* sin(yaw), ...
          ways(:, 2) .* cos(yaw) - ways(:, 1) .* sin(yaw)];
end
