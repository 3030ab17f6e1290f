function block = measureFlatTop(demo, n, others)
% Measures a carried object that began inside or on something unknown: its flat top of one color, in the last picture before
% a hand took it and in those in which it was held high. How far it moves in the picture tells its height; what stands upright,
% like a side, seems to be elsewhere in each picture. Returns the object as a block around its center, as high below it as
% above, at its first place; a 1x0 struct array if no picture shows it.
%   others  blocks that are measured already
  block = noBlocks();
  if ~any(demo.placed == n), return; end
  moves = demo.moves(demo.moves(:, 2) == n, [1, 3:8]);
  frames = pictureFrames(demo);
  earlier = frames(frames < min(graspFrames(demo, demo.ids{n})));
  if isempty(earlier), return; end
  first = readPicture(demo, earlier(end));
  tops = noBlocks();
  [~, order] = sort(-moves(:, 4));
  for row = moves(order(1:min(constants().task_model.num_highest_frames, end)), :)'
    later = readPicture(demo, row(1));
    if isempty(later), continue; end
    % Where it is held high, closer to the eye, its sides have more pixels.
    tops = [tops, partsBetween({later, first}, [row(2:7)'; moves(1, 2:7)], demo.eye, true)];
  end
  if isempty(tops), return; end
  groups = arrayfun(@(one) find(arrayfun(@(it) isSameTop(it, one), tops)), tops, 'UniformOutput', false);
  counts = cellfun(@numel, groups);
  heights = cellfun(@(it) tops(it(1)).position(3), groups);
  heights(2 * counts <= max(counts)) = -Inf;
  [~, best] = max(heights);
  group = tops(groups{best});
  places = vertcat(group.position);
  sizes = vertcat(group.size);
  sides = median([sizes(:, 1:2), 2 * places(:, 3)], 1);
  % Two things that are almost of the same size are alike.
  for it = others
    if sameSize(sides, it.size)
      sides = it.size;
      break
    end
  end
  block = newBlock(group(1).color, sides, moves(1, 2:4), moves(1, 7) * pi / 180, group(1).form);
end

function yes = isSameTop(one, other)
% Returns true if two parts may be one, seen in different pictures.
  yes = sameColor(one.color, other.color) && strcmp(one.form, other.form) && ...
        norm(one.position - other.position) < constants().parts.same_place;
end
