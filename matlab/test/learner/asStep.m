function step = asStep(it)
  step = newStep(it, 'step');
end
