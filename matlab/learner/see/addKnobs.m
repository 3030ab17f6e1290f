function seen = addKnobs(steps, seen)
% Adds the knobs of steps that are known to seen blocks.
  for step = steps(~cellfun(@isempty, {steps.knob}))
    for k = 1:numel(seen)
      if isSameKind(seen(k), step), seen(k).knob = step.knob; end
    end
  end
end
