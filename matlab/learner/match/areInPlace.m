function yes = areInPlace(blocks, steps)
% Returns which of N blocks are in the places of M steps: MxN logical.
  yes = false(numel(steps), numel(blocks));
  for k = 1:numel(steps), yes(k, :) = arrayfun(@(it) isInPlace(it, steps(k)), blocks); end
end
