function sides = sidesAround(picture, eye, color, pose, height, min_seen)
% Returns the sides of a top of a color at a pose, if its middle is not visible, but this fraction of it; otherwise [].
  sides = [];
  c = constants();
  top = pose(1:3) + [0, 0, height / 2];
  [~, pixel] = colorAt(picture, eye, top);
  if ~isColorNear(picture, color, pixel), return; end
  number = labelRegions(colorMask(picture, color));
  [row, column, regions] = find(number);
  for region = find(accumarray(regions, 1) >= c.perception.min_rim_pixels)'
    if number(pixel(2), pixel(1)) == region, continue; end
    inside = regions == region;
    [x, y, area] = ontoPlane(row(inside), column(inside), eye, top(3));
    face = smallestRectangle(x, y, sqrt(median(area)), pose(6) * pi / 180);
    if norm(face.center - top(1:2)) < c.task_model.max_container_error && ...
       sum(area) > min_seen * prod(face.sides)
      sides = face.sides;
      return
    end
  end
end
