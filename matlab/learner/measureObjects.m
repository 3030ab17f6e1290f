function appearances = measureObjects(demo, which)
% Measures the appearance of objects of a demonstration in its pictures: the texts contain the pose of
% each object in each picture, so its top can be found there.
%   which                  numbers of the objects
%   appearances(n).color   1x3, red green blue, 0 to 1
%   appearances(n).size    along its own x, y and z axes [units]
  appearances = struct('color', {}, 'size', {});
  pictures = containers.Map('KeyType', 'double', 'ValueType', 'any');  % cache
  for n = which
    height = 2 * demo.start(n, 3);  % it stood on the table at the start
    sides = [];
    for k = selectFrames(demo, n)
      frame = demo.moves(k, 1);
      if ~pictures.isKey(frame), pictures(frame) = readPicture(demo, frame); end
      [color, sides] = measureTop(pictures(frame), demo.eye, demo.moves(k, 3:8), height);
      if ~isempty(sides), break; end
    end
    if isempty(sides)
      error('no picture of the demonstration shows %s entirely', demo.ids{n});
    end
    appearances(n) = struct('color', color, 'size', [sides, height]);
  end
end

function rows = selectFrames(demo, n)
% Returns the rows of demo.moves after which an object may be entirely visible: its first, and those where
% it was highest.
  rows = find(demo.moves(:, 2) == n);
  [~, order] = sort(-demo.moves(rows, 5));
  rows = rows([1; order(1:min(constants().task_model.num_highest_frames, end))])';
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
