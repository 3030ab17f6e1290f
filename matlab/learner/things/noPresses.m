function presses = noPresses()
% Returns an empty list of presses, a 1x0 struct array: see newPress.
  presses = newPress('', [], [], [], []);
  presses(1) = [];
end
