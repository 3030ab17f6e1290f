function blocks = heldAnyhow(block)
% Returns a block, and that block held by each other part by which it can be held: a 1xN struct array, the best first.
  blocks = block;
  for knob = block.otherKnobs
    blocks(end + 1) = setfield(block, 'knob', knob);
    blocks(end).otherKnobs = [];
  end
end
