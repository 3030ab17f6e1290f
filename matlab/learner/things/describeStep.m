function text = describeStep(step)
% Returns the name and the size [units] of a step, for messages.
  text = sprintf('%s (%.3g x %.3g x %.3g)', step.name, step.size);
end
