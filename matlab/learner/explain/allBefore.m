function numbers = allBefore(numbers, steps)
% Returns numbers of steps with those of all steps that must be done before them, in order.
  for k = numel(steps):-1:1
    if any(numbers == k), numbers = [numbers, steps(k).on, steps(k).after]; end
  end
  numbers = reshape(unique(numbers), 1, []);
end
