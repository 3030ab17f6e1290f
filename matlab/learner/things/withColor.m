function state = withColor(state, color, seen)
% Gives all that is wanted in a color another one: see knowColors.
  state.steps = recolored(state.steps, color, seen);
  for k = find(~cellfun(@isempty, {state.steps.beganOn}))
    state.steps(k).beganOn.like = recolored(state.steps(k).beganOn.like, color, seen);
  end
  state.unknownObjects = recolored(state.unknownObjects, color, seen);
  state.containers = recolored(state.containers, color, seen);
  for k = 1:numel(state.presses), state.presses(k).tool = recolored(state.presses(k).tool, color, seen); end
end

function things = recolored(things, color, seen)
% Changes the color of things, of their knobs and of their parts.
  for k = 1:numel(things)
    if isequal(things(k).color, color), things(k).color = seen; end
    if ~isempty(things(k).knob), things(k).knob = recolored(things(k).knob, color, seen); end
    if ~isempty(things(k).parts), things(k).parts = recolored(things(k).parts, color, seen); end
  end
end
