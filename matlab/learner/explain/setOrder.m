function steps = setOrder(steps, attention)
% Determines what each step stands on, and what else must be done before it: what it will cover, and, where the
% demonstrator attended the order of an object, all that was placed before.
%   attention  as in aux
  n = numel(steps);
  carries = false(n);  % (k, i): step i carries step k, directly or not
  is_ordered = arrayfun(@(step) any(strcmp(attended(attention, step.name), 'order')), steps);
  for k = 1:n
    for i = 1:k - 1
      if standsOn(steps(k), steps(i)), steps(k).on(end + 1) = i; end
    end
    carries(k, :) = any(carries(steps(k).on, :), 1);
    carries(k, steps(k).on) = true;
    for i = 1:k - 1
      is_covered = ~carries(k, i) && isAbove(steps(k), steps(i));
      if is_covered || (~steps(i).stays && (is_ordered(k) || is_ordered(i))), steps(k).after(end + 1) = i; end
    end
  end
end
