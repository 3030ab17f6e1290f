function text = describeStep(step)
% For people.
  text = sprintf('%s (%.3g x %.3g x %.3g)', step.name, step.size);
end
