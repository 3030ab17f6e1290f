function block = measureParts(demo, n)
% Measures the parts of object n of a demonstration, the flat tops of one color that move with it, in two pictures, before
% and while it was moved. Returns the object as a block at its first place, a 1x0 struct array if fewer than two parts are
% found.
%   block.parts  blocks in the frame of the object: the position is that of the middle of the part's top from the object's
%                center, the yaw is from the object's
  block = noBlocks();
  moves = demo.moves(demo.moves(:, 2) == n, [1, 3:8]);
  if ~any(demo.placed == n), return; end
  first = readPicture(demo, moves(1, 1));
  if isempty(first), return; end
  [~, order] = sort(-moves(:, 4));
  for row = moves(order(1:min(constants().task_model.num_highest_frames, end)), :)'
    later = readPicture(demo, row(1));
    if isempty(later) || row(1) == moves(1, 1), continue; end
    parts = partsBetween({first, later}, [moves(1, 2:7); row(2:7)'], demo.eye);
    if numel(parts) > 1
      block = wholeOf(parts, moves);
      return
    end
  end
end

function block = wholeOf(parts, moves)
% Returns the object that parts belong to, as a block at its first place: as wide as they are on both sides of its center,
% and as high below it as above, unless it was lower than that.
  places = vertcat(parts.position);
  sizes = vertcat(parts.size);
  sides = max(2 * abs(places(:, 1:2)) + sizes(:, 1:2), [], 1);
  height = 2 * min(max(places(:, 3)), min(moves(:, 4)));
  [~, largest] = max(prod(sizes(:, 1:2), 2));
  block = newBlock(parts(largest).color, [sides, height], moves(1, 2:4), moves(1, 7) * pi / 180);
  block.parts = parts;
end
