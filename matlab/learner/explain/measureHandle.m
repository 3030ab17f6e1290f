function step = measureHandle(demo, n)
% Measures the handle by which object n of a demonstration was dragged, as a step (see newStep): the
% highest flat top with the same displacement as the object. The closer to the eye a top is, the farther
% it moves in the picture; so its displacement in the picture determines its height.
  c = constants();
  rows = find(demo.moves(:, 2) == n);
  pictures = {readPicture(demo, demo.moves(rows(1), 1)), readPicture(demo, demo.moves(rows(end), 1))};
  displacement = demo.final(n, 1:2) - demo.start(n, 1:2);
  eye_height = demo.eye.pose(3, 4);
  step = struct('position', [0, 0, 0]);
  colors = zeros(3, 0);
  if ~any(cellfun(@isempty, pictures)), colors = colorsToDetect(pictures{1}, struct('color', [])); end
  for color = colors
    masks = cellfun(@(picture) colorMask(picture, color'), pictures, 'UniformOutput', false);
    for before = displacedRegions(masks{1}, masks{2})
      for after = displacedRegions(masks{2}, masks{1})
        on_table = centerOf(after{1}, demo.eye, 0) - centerOf(before{1}, demo.eye, 0);
        height = eye_height * (1 - sum(displacement .^ 2) / sum(displacement .* on_table));
        if ~(height > c.task_model.min_handle_height && height < eye_height / 2), continue; end
        [at, face] = centerOf(before{1}, demo.eye, height);
        [there, later] = centerOf(after{1}, demo.eye, height);
        if norm(there - at - displacement) < c.task_model.max_handle_error && ...
           face.misfit < c.perception.misfit && sameSize(face.sides, later.sides) && ...
           height / 2 > step.position(3)
          step = newStep(newBlock(color', [face.sides, height], [at, height / 2], face.yaw), demo.ids{n});
          step.displacement = displacement;
          % Its direction is only as well known as the yaw of the handle.
          step.tolerance = c.blocks.position_tolerance + c.task_model.drag_direction_rad * norm(displacement);
        end
      end
    end
  end
  if step.position(3) == 0
    notUnderstood('no picture of the demonstration shows the handle of %s', demo.ids{n});
  end
end

function [center, face] = centerOf(pixels, eye, height)
% Returns the center, 1x2 [units], of the face that pixels form at a height, and the face.
  [x, y, area] = ontoPlane(pixels(:, 1), pixels(:, 2), eye, height);
  face = fitFace(x, y, area);
  center = face.center;
end
