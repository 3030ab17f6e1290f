function blocks = withHeldParts(blocks)
% Returns blocks and their knobs.
  if isempty(blocks), blocks = noBlocks(); end  % two empty lists together have no fields
  for it = blocks(~cellfun(@isempty, {blocks.knob})), blocks(end + 1) = heldPart(it); end
end
