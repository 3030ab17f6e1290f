function frames = selectFrames(demo, n)
% Returns the frames in which an object may be entirely visible, with its pose, Mx7: its first; then those where it was highest,
% and some in which others were moved, which may have covered it before, first those in which a pixel shows the least of it.
  c = constants().task_model;
  moves = demo.moves(demo.moves(:, 2) == n, [1, 3:8]);
  [~, order] = sort(-moves(:, 4));
  frames = moves([1; order(1:min(c.num_highest_frames, end))], :);
  all_frames = unique(demo.moves(:, 1));
  chosen = floor((0:c.num_other_frames - 1) * (numel(all_frames) - 1) / (c.num_other_frames - 1));
  for frame = reshape(all_frames(1 + chosen), 1, [])
    row = find(moves(:, 1) <= frame, 1, 'last');
    if ~isempty(row), frames(end + 1, :) = [frame, moves(row, 2:7)]; end
  end
  [~, order] = sort(pixelExtent(frames(2:end, 2:4), demo.eye));
  frames(2:end, :) = frames(1 + order, :);
end

function extent = pixelExtent(places, eye)
% Returns how much of a level area at each of N places, Nx3, a pixel shows, away from the eye, but for a factor: Nx1.
  away = eye.pose(1:3, 4)' - places;
  extent = sum(away .^ 2, 2) ./ away(:, 3);
  extent(away(:, 3) <= 0) = Inf;
end
