function [step, problem] = placeOfOther(step, steps, known)
% Moves a step that takes the place of another object to where that is now: the known block that looks like it and stands
% most nearly as high as it did. A problem says if there is none.
  problem = '';
  other = steps(find(strcmp({steps.name}, step.takesPlaceOf), 1));
  found = known(arrayfun(@(block) isSameKind(block, other), known));
  if isempty(found)
    problem = sprintf('no visible object looks like %s, whose place %s takes', describeStep(other), step.name);
    return
  end
  [~, nearest] = min(arrayfun(@(it) abs(it.position(3) - other.start(3)), found));
  step.position(1:2) = found(nearest).position(1:2);
  step.yaw = step.yaw + yawDifference(step, found(nearest).yaw);
end
