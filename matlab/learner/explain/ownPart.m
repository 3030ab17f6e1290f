function own = ownPart(changed, demo, control, frame)
% Returns the part of a mask of what a press in a frame changed that belongs to the object of the control: the lights that a switch drives may
% be on another one. All of it, if nothing else is visible. Regions belong to the nearest of the objects with controls.
  own = changed;
  rows_of = {demo.events(strcmp({demo.events.word}, 'initializeControl')).fields};
  if isempty(rows_of), return; end
  controls = cellfun(@(fields) fields{1}, rows_of, 'UniformOutput', false);
  owners = cellfun(@(fields) fields{3}, rows_of, 'UniformOutput', false);
  names = unique(owners);
  k = find(strcmp(controls, control), 1);
  if numel(names) < 2 || isempty(k), return; end
  own = false(size(changed));
  number = largeRegions(changed);
  for region = unique(number(number > 0))'
    [row, column] = find(number == region);
    distances = cellfun(@(name) distanceTo(name, row, column, demo, frame), names);
    [~, nearest] = min(distances);
    if strcmp(names{nearest}, owners{k}), own(number == region) = true; end
  end
  if ~any(own(:)), own = changed; end
end

function distance = distanceTo(name, row, column, demo, frame)
% Returns the distance of an object of a demonstration from what some pixels show at its height [units].
  position = poseBefore(demo, find(strcmp(demo.ids, name)), frame)(1:3);
  [x, y] = ontoPlane(row, column, demo.eye, position(3));
  distance = hypot(mean(x) - position(1), mean(y) - position(2));
end
