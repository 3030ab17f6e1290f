function box = boxAround(load)
% Returns the lower and the upper corner of a box around points, which are one for each cell, 2x3 [units].
  half = constants().skyline.cell / 2;
  box = [min(load, [], 1) - half; max(load, [], 1) + half];
end
