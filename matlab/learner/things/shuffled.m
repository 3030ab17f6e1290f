function items = shuffled(items, seed)
% Returns columns in an order that a seed draws, a column of whole numbers; unchanged if it is [].
  if isempty(seed), return; end
  rand('twister', seed);
  items = items(:, randperm(columns(items)));
end
