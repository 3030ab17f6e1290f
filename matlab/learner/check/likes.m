function [like, staying] = likes(state)
% Returns what blocks may look like: those of the steps, unknown objects, and tools; and those among them on whose tops
% others stand, or a knob.
  like = joined(asBlocks(state.steps), state.unknownObjects);
  for press = state.presses(~cellfun(@isempty, {state.presses.tool})), like(end + 1) = asBlocks(press.tool); end
  staying = asBlocks(state.steps([state.steps.stays] | [state.steps.hasKnob]));
  for it = startSupportsOf(state.steps), staying(end + 1) = it; end
end
