function appearances = measureObjects(demo, needed)
% Measures the appearance of the objects of a demonstration in its pictures: the texts contain the pose of
% each object in each picture, so its top can be found there. An object began on the table or on a lower one;
% its height is twice the distance of its middle from there.
%   needed                 numbers of objects; others are left out, with [], if no picture shows them
%   appearances(n).color   1x3, red green blue, 0 to 1
%   appearances(n).size    along its own x, y and z axes [units]
%   appearances(n).isRound true for a disc or a ball
  appearances = repmat(struct('color', [], 'size', [], 'isRound', false), 1, numel(demo.ids));
  at_start = noBlocks();  % those measured so far, at their first places
  pictures = containers.Map('KeyType', 'double', 'ValueType', 'any');  % cache
  [~, order] = sort(demo.start(:, 3));
  for n = order'
    [found, is_round] = measureObject(demo, n, at_start, pictures);
    if ~isempty(found)
      appearances(n) = struct('color', found.color, 'size', found.size, 'isRound', is_round);
      at_start(end + 1) = found;
    elseif any(needed == n)
      error('no picture of the demonstration shows %s entirely', demo.ids{n});
    end
  end
end

function [block, is_round] = measureObject(demo, n, lower, pictures)
% Measures an object in the first frame that shows it entirely. Returns it as a block at its first place, a
% 1x0 struct array if there is none, and whether it is round.
%   lower     blocks that it may have stood on at the start
%   pictures  cache
  block = noBlocks();
  is_round = false;
  start = demo.start(n, :);
  frames = selectFrames(demo, n);
  tops = arrayfun(@(it) it.position(3) + it.size(3) / 2, lower);
  % A lower block may be below: of a stack, the top of the whole could be that of a high block.
  for bottom = fliplr(unique([0, tops(tops < start(3))]))
    height = 2 * (start(3) - bottom);
    for row = frames'
      if ~pictures.isKey(row(1)), pictures(row(1)) = readPicture(demo, row(1)); end
      [color, sides, is_round] = measureTop(pictures(row(1)), demo.eye, row(2:7)', height);
      if isempty(sides), continue; end
      found = struct('color', color, 'size', [sides, height], 'position', start(1:3), ...
                     'yaw', start(6) * pi / 180);
      if bottom == 0 || any(arrayfun(@(it) standsOn(found, it), lower))
        block(1) = found;
        return
      end
    end
  end
  [block, is_round] = measureBall(demo, start, frames, pictures);
  if isempty(block), block = measureTopWithKnob(demo, n, frames, pictures); end
end

function [block, is_round] = measureBall(demo, start, frames, pictures)
% Measures an object that may be a ball on the table, like measureObject.
  block = noBlocks();
  radius = start(3);
  for row = frames'
    if isempty(pictures(row(1))), continue; end
    color = ballColor(pictures(row(1)), demo.eye, row(2:4)', radius);
    if isempty(color), continue; end
    block(1) = struct('color', color, 'size', 2 * radius * [1, 1, 1], 'position', start(1:3), 'yaw', 0);
    break
  end
  is_round = ~isempty(block);
end

function [color, sides, is_round] = measureTop(picture, eye, pose, height)
% Measures the top of an upright object at a pose, 1x6 [units, degrees]: its color, 1x3, and its sides
% along the object's x and y axes [units], [] if it is not entirely visible; and whether it is a disc.
  sides = [];
  is_round = false;
  top = pose(1:3) + [0, 0, height / 2];
  [color, pixel] = colorAt(picture, eye, top);
  if isempty(color), return; end
  number = labelRegions(colorMask(picture, color));
  [row, column] = find(number == number(pixel(2), pixel(1)));
  [x, y, area] = ontoPlane(row, column, eye, top(3));
  face = fitFace(x, y, area, pose(6) * pi / 180);
  c = constants();
  is_whole = norm(face.center - top(1:2)) < c.task_model.max_center_error && face.misfit < c.perception.misfit;
  is_round = face.isRound;
  if is_whole, sides = face.sides; end
end
