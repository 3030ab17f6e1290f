function blocks = joined(some, others)
% Returns two lists of blocks as one. Octave's own concatenation of two empty lists has no fields.
  blocks = noBlocks();
  if ~isempty(some), blocks = some; end
  if isempty(some) && ~isempty(others), blocks = others; end
  if ~isempty(some) && ~isempty(others), blocks = [some, others]; end
end
