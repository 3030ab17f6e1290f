function [steps, seen] = findKnobs(steps, seen, picture, eye, heights)
% Finds the knobs of seen blocks whose steps have one, like those of lids: adds them to the steps and the blocks.
%   heights  as from heightMap
  for k = find([steps.hasKnob] & cellfun(@isempty, {steps.knob}))
    for block = seen(arrayfun(@(it) isSameKind(it, steps(k)), seen))
      others = detectUnknownObjects(picture, eye, seen, heights);
      on_it = others(arrayfun(@(it) standsOn(it, block), others));
      if ~isempty(on_it), steps(k).knob = inFrameOf(block, on_it(1)); end
    end
  end
  seen = addKnobs(steps, seen);
end

function part = inFrameOf(block, part)
% Returns a part of a block in the frame of the block.
  away = part.position - block.position;
  part.position = [rotated(away(1:2), -block.yaw), away(3)];
  part.yaw = part.yaw - block.yaw;
end
