function looks = measureObjects(demo, which)
% What objects of the demonstration look like, from its pictures: the log tells where each object is in
% each picture, so its top can be found there.
%   which           their numbers
%   looks(n).color  1x3, red green blue, 0 to 1
%   looks(n).size   along its own x, y and z axes [units]
  looks = struct('color', {}, 'size', {});
  pictures = containers.Map('KeyType', 'double', 'ValueType', 'any');  % those already read
  for n = which
    height = 2 * demo.start(n, 3);  % it began on the table
    sides = [];
    for k = worthLooking(demo, n)
      frame = demo.moves(k, 1);
      if ~pictures.isKey(frame), pictures(frame) = readPicture(demo, frame); end
      [color, sides] = measureTop(pictures(frame), demo.eye, demo.moves(k, 3:8), height);
      if ~isempty(sides), break; end
    end
    if isempty(sides)
      error('no picture of the demonstration shows %s well enough to tell what it is', demo.ids{n});
    end
    looks(n) = struct('color', color, 'size', [sides, height]);
  end
end

function rows = worthLooking(demo, n)
% Moves of an object after which it may be seen as a whole: at the beginning, and where it was highest.
  rows = find(demo.moves(:, 2) == n);
  [~, order] = sort(-demo.moves(rows, 5));
  rows = rows([1; order(1:min(constants().understand.highest_frames, end))])';
end

function [color, sides] = measureTop(picture, eye, pose, height)
% The color of the top of an upright object, 1x3, and how long it is along the object's x and y axes;
% [] if it is not seen as a whole.
  sides = [];
  top = pose(1:3) + [0, 0, height / 2];
  [color, spot] = colorAt(picture, eye, top);
  if isempty(color), return; end
  number = labelRegions(isColor(picture, color));
  [row, column] = find(number == number(spot(2), spot(1)));
  [x, y, area] = ontoPlane(row, column, eye, top(3));
  face = describeFace(x, y, area, pose(6) * pi / 180);
  c = constants();
  is_whole = norm(face.center - top(1:2)) < c.understand.center_error && face.misfit < c.see.misfit;
  if is_whole, sides = face.sides; end
end
