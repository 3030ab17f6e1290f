function step = measureHandle(demo, n)
% What object n of a demonstration can be drawn by, as a step (see understand): the highest flat top that
% went the same way as the object. The nearer to the eye something is, the farther it goes in the
% picture; so the way in the picture tells how high it is.
  c = constants();
  rows = find(demo.moves(:, 2) == n);
  pictures = {readPicture(demo, demo.moves(rows(1), 1)), readPicture(demo, demo.moves(rows(end), 1))};
  way = demo.final(n, 1:2) - demo.start(n, 1:2);
  eye_height = demo.eye.pose(3, 4);
  step = struct('position', [0, 0, 0]);
  colors = zeros(3, 0);
  if ~any(cellfun(@isempty, pictures)), colors = colorsIn(pictures{1}, struct('color', [])); end
  for color = colors
    masks = cellfun(@(picture) isColor(picture, color'), pictures, 'UniformOutput', false);
    for before = regionsLeft(masks{1}, masks{2})
      for after = regionsLeft(masks{2}, masks{1})
        on_table = centerOf(after{1}, demo.eye, 0) - centerOf(before{1}, demo.eye, 0);
        height = eye_height * (1 - sum(way .^ 2) / sum(way .* on_table));
        if ~(height > c.understand.handle_height && height < eye_height / 2), continue; end
        [at, face] = centerOf(before{1}, demo.eye, height);
        [there, later] = centerOf(after{1}, demo.eye, height);
        if norm(there - at - way) < c.understand.handle_error && face.misfit < c.see.misfit && ...
           sameSize(face.sides, later.sides) && height / 2 > step.position(3)
          step = struct('name', demo.ids{n}, 'color', color', 'size', [face.sides, height], ...
                        'position', [at, height / 2], 'yaw', face.yaw, 'on', [], 'way', way);
        end
      end
    end
  end
  if step.position(3) == 0
    error('no picture of the demonstration shows by what %s was drawn', demo.ids{n});
  end
end

function regions = regionsLeft(mask, other)
% The connected pixels of a mask, a 1xN cell of [row, column], that are mostly not in another mask.
  number = labelRegions(mask);
  regions = {};
  for region = find(accumarray(number(number > 0), 1) >= constants().see.top_pixels)'
    [row, column] = find(number == region);
    if mean(other(number == region)) < constants().understand.left_behind, regions{end + 1} = [row, column]; end
  end
end

function [center, face] = centerOf(pixels, eye, height)
  [x, y, area] = ontoPlane(pixels(:, 1), pixels(:, 2), eye, height);
  face = describeFace(x, y, area);
  center = face.center;
end
