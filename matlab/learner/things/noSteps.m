function steps = noSteps()
% Returns an empty list of steps, a 1x0 struct array: see newStep.
  steps = newStep(newBlock([], [], [], 0), '');
  steps(1) = [];
end
