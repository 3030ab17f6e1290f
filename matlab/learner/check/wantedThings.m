function things = wantedThings(state)
% Returns the steps, what they began on, the tools and the containers as blocks, 1xN, with isStaying, true for what carries
% others or a knob, and isBox, true for containers.
  things = asBlocks(state.steps);
  is_staying = [state.steps.stays] | [state.steps.hasKnob];
  for it = startSupportsOf(state.steps), [things(end + 1), is_staying(end + 1)] = deal(it, true); end
  for press = state.presses(~cellfun(@isempty, {state.presses.tool})), things(end + 1) = asBlocks(press.tool); end
  num_others = numel(things);
  things = joined(things, asBlocks(state.containers));
  for k = 1:numel(things)
    things(k).isStaying = k <= numel(is_staying) && is_staying(k);
    things(k).isBox = k > num_others;
  end
end
