function container = measureContainer(demo, steps)
% Measures the open box that the blocks of steps were put into, in the first picture of the demonstration;
% [] if all of them stand on the table or on each other, or if there are no texts.
% A block (see newBlock), and
%   name   of the object in the demonstration, for messages
%   floor  height of its floor above the table [units]
  container = [];
  c = constants().task_model;
  bottoms = arrayfun(@(step) step.position(3) - step.size(3) / 2, steps);
  is_carried = cellfun(@isempty, {steps.displacement});
  inside = steps(bottoms > c.min_inside_bottom & cellfun(@isempty, {steps.on}) & is_carried & ...
                 cellfun(@isempty, {steps.takesPlaceOf}));
  if isempty(inside) || isempty(demo.moves), return; end
  still = setdiff(1:numel(demo.ids), demo.placed);
  away = demo.start(still, 1:2) - inside(1).position(1:2);
  [~, order] = sort(hypot(away(:, 1), away(:, 2)));
  left_out = '';  % a step that is in none of the containers of others
  for n = still(order)
    height = 2 * demo.start(n, 3);  % it stands on the table
    % The first picture and the color in the middle, usually that of its floor, come first: later something
    % else may cover it, or no longer.
    for row = selectFrames(demo, n)'
      picture = readPicture(demo, row(1));
      color = colorAt(picture, demo.eye, demo.start(n, 1:3) + [0, 0, height / 2]);
      if isempty(color), continue; end
      for color = [color', frequentColors(picture, constants().perception.min_rim_pixels)]
        [container, outside] = containerAt(demo, n, picture, color', height, inside);
        if isempty(container), continue; end
        if isempty(outside), return; end
        left_out = outside;
        holder = container.name;
      end
    end
  end
  if ~isempty(left_out)
    notUnderstood('something was put into %s, but %s on or into something else: one container is understood', holder, left_out);
  end
  notUnderstood('no picture of the demonstration shows on or in what %s was put; an arm may hide it', inside(1).name);
end

function [container, outside] = containerAt(demo, n, picture, color, height, inside)
% Returns object n of a demonstration as a container with a rim of a color, if a picture shows it around
% the objects of some steps, and the name of one that it is not around, or ''; otherwise [].
  outside = '';
  for face = detectRims(picture, demo.eye, color, height)
    if norm(face.center - demo.start(n, 1:2)) > constants().task_model.max_center_error, continue; end
    bottoms = arrayfun(@(step) step.position(3) - step.size(3) / 2, inside);
    container = newBlock(color, [face.sides, height], [face.center, height / 2], face.yaw);
    if face.isRound
      container.form = 'disc';
      container.yaw = 0;
    end
    container.name = demo.ids{n};
    container.floor = min(bottoms);
    is_inside = arrayfun(@(step) isInside(container, step.position), inside);
    if all(is_inside), return; end
    if any(is_inside)
      outside = inside(find(~is_inside, 1)).name;
      return
    end
  end
  container = [];
end
