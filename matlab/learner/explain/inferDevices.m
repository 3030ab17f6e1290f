function presses = inferDevices(demo, steps, appearances, needs)
% Returns the presses of controls and the uses of tools in a demonstration, in their order: a 1xN struct array, see newPress.
% Throws notUnderstood if the pictures do not show what one of them changed.
%   appearances  as from measureObjects
%   needs        what the goal needs, if it is known: see needsOf
  if nargin < 4, needs = []; end
  presses = noPresses();
  if ~isfield(demo, 'events'), return; end
  placed = {};  % names of the objects that were released so far for the last time
  num_released = 0;
  is_driving = false;
  for i = 1:numel(demo.events)
    event = demo.events(i);
    if strcmp(event.word, 'release')
      num_released = num_released + 1;
      n = demo.placed(num_released);
      if ~any(demo.placed(num_released + 1:end) == n), placed{end + 1} = demo.ids{n}; end
    end
    is_driving = is_driving && ~strcmp(event.word, 'grasp');
    if ~any(strcmp(event.word, {'use', 'trigger', 'press'})), continue; end
    after = find([steps.stays] | ismember({steps.name}, placed));
    if ~isempty(needs)
      if ~isNeeded(needs, demo.segments(i)), continue; end
      is_before = arrayfun(@(k) steps(k).stays || mustPrecede(needs, steps(k), demo.segments(i)), after);
      after = allBefore(after(is_before), steps);
    end
    if strcmp(event.word, 'use') && any(strcmp(constants().uses.turning, event.fields{3}))
      drives = presses(~cellfun(@isempty, {presses.turns}));
      if ~is_driving, presses(end + 1) = driveAt(demo, event, after, drives, appearances); end
      is_driving = true;
    elseif strcmp(event.word, 'use')
      presses(end + 1) = useAt(demo, event, after, appearances);
    else
      control = event.fields{1 + strcmp(event.word, 'trigger')};
      [before, later, changed] = changes(demo, event.frame, event.frame + 1, control);
      presses(end + 1) = newPress(control, after, before, later, ownPart(changed, demo, control, event.frame));
    end
  end
  for k = find(cellfun(@isempty, {presses.tool}))
    presses(k).changed = presses(k).changed & placeOfControl(presses(k).control, presses);
    if ~any(presses(k).changed(:))
      notUnderstood('no picture of the demonstration shows what was changed at %s', presses(k).control);
    end
  end
  for k = 1:numel(presses)
    presses(k).unchanged = unchangedBy(presses(k), presses);
  end
end

function number = unchangedBy(press, presses)
% Returns the numbers of the regions that other presses of its control changed, and it did not: HxW; 0 elsewhere.
  of_control = {presses(strcmp({presses.control}, press.control)).changed};
  number = largeRegions(any(cat(3, of_control{:}), 3) & ~press.changed);
end

function mask = placeOfControl(control, presses)
% Returns the mask of a rectangle around all that some press of a control changed, of the one that changed least: at
% others, something else may have moved a little.
  margin = constants().presses.margin_pixels;
  mask = false(size(presses(1).changed));
  least = Inf;
  for press = presses(strcmp({presses.control}, control))
    [row, column] = find(press.changed);
    low = max([min(row), min(column)] - margin, 1);
    high = [max(row), max(column)] + margin;
    if prod(high - low + 1) >= least, continue; end
    least = prod(high - low + 1);
    mask(:) = false;
    mask(low(1):min(high(1), end), low(2):min(high(2), end)) = true;
  end
end
