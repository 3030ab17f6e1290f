function blocks = noBlocks()
% Returns an empty list of blocks, a 1x0 struct array: see newBlock.
  blocks = struct('color', {}, 'size', {}, 'position', {}, 'yaw', {}, 'form', {}, 'hasKnob', {}, 'knob', {}, ...
                  'otherKnobs', {}, 'parts', {}, 'outline', {}, 'depth', {});
end
