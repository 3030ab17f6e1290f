function containers = measureContainers(demo, steps)
% Measures the open boxes that the blocks of steps were put into, in the first picture of the demonstration: a 1xN struct
% array; [] if all of them stand on the table or on each other, or if there are no texts.
% A block (see newBlock), and
%   name   of the object in the demonstration, for messages
%   floor  height of its floor above the table [units]
  containers = [];
  c = constants().task_model;
  bottoms = arrayfun(@bottomOf, steps);
  is_carried = cellfun(@isempty, {steps.displacement});
  inside = steps(bottoms > c.min_inside_bottom & cellfun(@isempty, {steps.on}) & is_carried & ...
                 cellfun(@isempty, {steps.takesPlaceOf}));
  if isempty(demo.moves), return; end
  while ~isempty(inside)
    container = containerOf(demo, inside);
    containers = [containers, container];
    inside = inside(~isIn(inside, container));
  end
end

function best = containerOf(demo, inside)
% Measures the container of the first of some steps: of what may be one, that which most of them are in. If something hides a part
% of a box in all pictures, like an arm, its place and its yaw are those of the texts.
  best = bestContainer(demo, inside, false);
  if isempty(best), best = bestContainer(demo, inside, true); end
  if ~isempty(best), return; end
  notUnderstood('no picture of the demonstration shows on or in what %s was put; an arm may hide it', inside(1).name);
end

function best = bestContainer(demo, inside, is_half_hidden)
% Returns the container that the first of some steps and most others are in, or [].
  best = [];
  most = 0;
  still = setdiff(1:numel(demo.ids), demo.placed);
  away = demo.start(still, 1:2) - inside(1).position(1:2);
  [~, order] = sort(hypot(away(:, 1), away(:, 2)));
  for n = still(order)
    % The first picture and the color in the middle, usually that of its floor, come first: later something
    % else may cover it, or no longer.
    for row = selectFrames(demo, n)'
      picture = readPicture(demo, row(1));
      color = colorAt(picture, demo.eye, demo.start(n, 1:3) .* [1, 1, 2]);
      if isempty(color), continue; end
      for color = [color', frequentColors(picture, constants().perception.min_rim_pixels)]
        for container = rimsAt(demo, n, picture, color', is_half_hidden)
          is_in = isIn(inside, container);
          if ~is_in(1) || sum(is_in) <= most, continue; end
          most = sum(is_in);
          best = container;
          best.floor = min(arrayfun(@bottomOf, inside(is_in)));
          if all(is_in), return; end
        end
      end
    end
  end
end

function yes = isIn(steps, container)
% Returns which of some steps are in a container, 1xN logical.
  yes = arrayfun(@(step) isInside(container, step.position), steps);
end

function bottom = bottomOf(step)
% Returns the height of the bottom of a step [units].
  bottom = step.position(3) - step.size(3) / 2;
end
