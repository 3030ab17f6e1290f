function kinds = blockKinds(steps, color)
% Returns the kinds of blocks of a color, 1x3, that steps need: a struct array with color and size.
  kinds = struct('color', {}, 'size', {});
  for k = 1:numel(steps)
    if ~sameColor(steps(k).color, color), continue; end
    known = false;
    for i = 1:numel(kinds), known = known || sameSize(kinds(i).size, steps(k).size); end
    if ~known, kinds(end + 1) = struct('color', color, 'size', steps(k).size); end
  end
end
