function things = wantedThings(state)
% Returns the steps, what they began on, the tools and the container as blocks, 1xN, with isStaying, true for what carries
% others or a knob, and isBox, true for the container.
  things = asBlocks(state.steps);
  is_staying = [state.steps.stays] | [state.steps.hasKnob];
  for it = startSupportsOf(state.steps), [things(end + 1), is_staying(end + 1)] = deal(it, true); end
  for press = state.presses(~cellfun(@isempty, {state.presses.tool})), things(end + 1) = asBlocks(press.tool); end
  if ~isempty(state.container), things(end + 1) = asBlocks(state.container); end
  for k = 1:numel(things)
    things(k).isStaying = k <= numel(is_staying) && is_staying(k);
    things(k).isBox = ~isempty(state.container) && k == numel(things);
  end
end
