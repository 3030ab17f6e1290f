function text = summary(steps, progress)
% One line for people.
  done = progress.step - 1;
  if done < numel(steps)
    text = sprintf('gave up at the %s block after %d tries', steps(done + 1).color, progress.tries);
  else
    text = sprintf('built: a tower of%s, as seen within %.3f units and %.1f degrees', ...
                   sprintf(' %s', steps.color), max(progress.miss(:, 1)), ...
                   max(progress.miss(:, 2)) * 180 / pi);
  end
end
