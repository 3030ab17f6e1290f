function appearances = measureObjects(demo, needed)
% Measures the appearance of the objects of a demonstration in its pictures: the texts contain the pose of
% each object in each picture, so its top can be found there. An object began on the table or on a lower one;
% its height is twice the distance of its middle from there.
%   needed                 numbers of objects; others are left out, with [], if no picture shows them
%   appearances(n).color   1x3, red green blue, 0 to 1
%   appearances(n).size    along its own x, y and z axes [units]
  appearances = repmat(struct('color', [], 'size', []), 1, numel(demo.ids));
  at_start = noBlocks();  % those measured so far, at their first places
  pictures = containers.Map('KeyType', 'double', 'ValueType', 'any');  % cache
  [~, order] = sort(demo.start(:, 3));
  for n = order'
    found = measureObject(demo, n, at_start, pictures);
    if ~isempty(found)
      appearances(n) = struct('color', found.color, 'size', found.size);
      at_start(end + 1) = found;
    elseif any(needed == n)
      error('no picture of the demonstration shows %s entirely', demo.ids{n});
    end
  end
end

function block = measureObject(demo, n, lower, pictures)
% Measures an object in the first frame that shows it entirely. Returns it as a block at its first place; a
% 1x0 struct array if there is none.
%   lower     blocks that it may have stood on at the start
%   pictures  cache
  block = noBlocks();
  start = demo.start(n, :);
  frames = selectFrames(demo, n);
  tops = arrayfun(@(it) it.position(3) + it.size(3) / 2, lower);
  % A lower block may be below: of a stack, the top of the whole could be that of a high block.
  for bottom = fliplr(unique([0, tops(tops < start(3))]))
    height = 2 * (start(3) - bottom);
    for row = frames'
      if ~pictures.isKey(row(1)), pictures(row(1)) = readPicture(demo, row(1)); end
      [color, sides] = measureTop(pictures(row(1)), demo.eye, row(2:7)', height);
      if isempty(sides), continue; end
      found = struct('color', color, 'size', [sides, height], 'position', start(1:3), ...
                     'yaw', start(6) * pi / 180);
      if bottom == 0 || any(arrayfun(@(it) standsOn(found, it), lower))
        block(1) = found;
        return
      end
    end
  end
end

function frames = selectFrames(demo, n)
% Returns the frames in which an object may be entirely visible, with its pose, Mx7: its first, those where
% it was highest, and some in which others were moved, which may have covered it before.
  c = constants().task_model;
  moves = demo.moves(demo.moves(:, 2) == n, [1, 3:8]);
  [~, order] = sort(-moves(:, 4));
  frames = moves([1; order(1:min(c.num_highest_frames, end))], :);
  all_frames = unique(demo.moves(:, 1));
  chosen = floor((0:c.num_other_frames - 1) * (numel(all_frames) - 1) / (c.num_other_frames - 1));
  for frame = all_frames(1 + chosen)'
    row = find(moves(:, 1) <= frame, 1, 'last');
    if ~isempty(row), frames(end + 1, :) = [frame, moves(row, 2:7)]; end
  end
end

function [color, sides] = measureTop(picture, eye, pose, height)
% Measures the top of an upright object at a pose, 1x6 [units, degrees]: its color, 1x3, and its sides
% along the object's x and y axes [units]; [] if it is not entirely visible.
  sides = [];
  top = pose(1:3) + [0, 0, height / 2];
  [color, pixel] = colorAt(picture, eye, top);
  if isempty(color), return; end
  number = labelRegions(colorMask(picture, color));
  [row, column] = find(number == number(pixel(2), pixel(1)));
  [x, y, area] = ontoPlane(row, column, eye, top(3));
  face = fitFace(x, y, area, pose(6) * pi / 180);
  c = constants();
  is_whole = norm(face.center - top(1:2)) < c.task_model.max_center_error && face.misfit < c.perception.misfit;
  if is_whole, sides = face.sides; end
end
