function able = armsFor(steps, arms)
% Returns the arms whose grippers can hold the blocks of all steps except those that stay or have a knob. It is an error
% if there are none.
  sizes = [0, 0, 0];
  for block = asBlocks(steps(~[steps.stays] & ~[steps.hasKnob])), sizes(end + 1, :) = heldPart(block).size; end
  width = max(sizes(:, 2));
  least = width + constants().arms.opening_margin;
  able = arms(arrayfun(@(arm) canHold(arm, width), arms));
  if ~isempty(able), return; end
  found = cell(1, numel(arms));
  for k = 1:numel(arms)
    found{k} = [arms(k).name, ': none'];
    if arms(k).opening > 0, found{k} = sprintf('%s: %.2f units', arms(k).name, arms(k).opening); end
  end
  error(['the robot has no gripper for blocks that are %.2f units wide: found %s; expected one that opens ' ...
         'at least %.2f units'], width, strjoin(found, ', '), least);
end
