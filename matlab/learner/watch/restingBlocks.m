function [blocks, numbers] = restingBlocks(objects, but)
% Returns the blocks among tracked objects (see newTracker) that rest, a 1xN struct array, and their numbers, 1xN.
%   but  number of one that is left out; optional
  numbers = find(~cellfun(@isempty, {objects.block}));
  if nargin > 1, numbers = setdiff(numbers, but); end
  blocks = noBlocks();
  for n = numbers, blocks(end + 1) = objects(n).block; end
end
