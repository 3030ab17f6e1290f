function blocks = startSupportsOf(steps)
% Returns what tells the objects of steps from others by being below them at the start, see startSupport: 1xN blocks.
  blocks = noBlocks();
  for step = steps(~cellfun(@isempty, {steps.beganOn}))
    if ~isempty(step.beganOn.like), blocks(end + 1) = step.beganOn.like; end
  end
end
