function [step, problem] = placeReturning(step, state)
% Moves a step that comes back to where its block is now, and its aside to what the scene shows of it there. A top that looks
% the same after half a turn is turned as the alignments tell. A problem says if the block is not visible.
  problem = '';
  found = state.known(arrayfun(@(block) isSameKind(block, step), state.known));
  if isempty(found)
    problem = [step.name, ' is not visible'];
    return
  end
  [~, nearest] = min(arrayfun(@(it) abs(it.position(3) - step.position(3)), found));
  block = found(nearest);
  alignment = state.alignments(strcmp({state.alignments.control}, step.name));
  at = step.aside.place.position;
  step.aside.place.position = [rotated(at(1:2) - alignment.place, -alignment.angle), at(3)];
  step.aside.place.yaw = step.aside.place.yaw - alignment.angle;
  angle = 0;
  if ~isempty(state.presses)
    alignment = alignmentOf(state.presses(1), state);
    angle = -alignment.angle;
  end
  step.position = block.position;
  step.yaw = directed(block, step.yaw + angle);
end
