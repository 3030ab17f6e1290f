function printSteps(steps)
% Prints the inferred steps.
  for k = 1:numel(steps)
    if isempty(steps(k).on)
      place = 'on the table';
    else
      place = ['on ', strjoin({steps(steps(k).on).name}, ', ')];
    end
    where = '';
    if ~isempty(steps(k).anchor), where = [', where it is relative to ', steps(k).anchor]; end
    if ~isempty(steps(k).beganOn), where = [where, '; it is the one that began on ', steps(k).beganOn.name]; end
    fprintf('shown: %d. %s %s%s\n', k, describeStep(steps(k)), place, where);
  end
end
