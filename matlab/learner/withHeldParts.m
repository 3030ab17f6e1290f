function blocks = withHeldParts(blocks)
% Returns blocks and their knobs.
  for it = blocks(~cellfun(@isempty, {blocks.knob})), blocks(end + 1) = heldPart(it); end
end
