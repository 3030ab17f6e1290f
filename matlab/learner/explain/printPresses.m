function printPresses(presses, steps)
% Prints the inferred presses of controls and uses of tools.
  for press = presses
    before = 'nothing';
    if ~isempty(press.after), before = strjoin({steps(press.after).name}, ', '); end
    printf('shown: %s after %s\n', describePress(press), before);
  end
end
