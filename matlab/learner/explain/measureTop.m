function [color, sides, form] = measureTop(picture, eye, pose, height)
% Measures the top of an upright object at a pose, 1x6 [units, degrees]: its color, 1x3, and its sides
% along the object's x and y axes [units], [] if it is not entirely visible or has another shape; and its form, see newBlock.
  sides = [];
  form = 'block';
  top = pose(1:3) + [0, 0, height / 2];
  [color, pixel] = colorAt(picture, eye, top);
  if isempty(color), return; end
  number = labelRegions(colorMask(picture, color));
  [row, column] = find(number == number(pixel(2), pixel(1)));
  [x, y, area] = ontoPlane(row, column, eye, top(3));
  face = fitFace(x, y, area, pose(6) * pi / 180);
  c = constants();
  is_whole = norm(face.center - top(1:2)) < c.task_model.max_center_error && face.misfit < c.perception.misfit;
  if is_whole && ~(face.isRound && isPolygon(x, y, area)), sides = face.sides; end
  if face.isRound, form = 'disc'; end
end
