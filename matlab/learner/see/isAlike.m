function yes = isAlike(colors, others)
% Returns which of N colors are equal to others, Nx3 or 1x3, as colorMask compares them: Nx1 logical.
  c = constants().perception;
  yes = max(abs(colors - others), [], 2) < c.color_tolerance + c.color_tolerance_bright * max(others, [], 2);
end
