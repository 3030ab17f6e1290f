function [state, used] = assessProgress(state)
% Compares the known blocks with the steps: updates state.done and state.placementErrors.
%   used  which known blocks are in the place of a step, 1xN logical
  c = constants().task_planning;
  known = state.known;
  used = false(1, numel(known));
  state.done(:) = false;
  for k = 1:numel(state.steps)
    step = state.steps(k);
    for i = find(~used)
      errors = [norm(known(i).position - step.position), abs(yawDifference(step, known(i).yaw))];
      if isSameKind(known(i), step) && errors(1) < c.position_tolerance && errors(2) < c.yaw_tolerance_rad
        state.placementErrors(k, :) = errors;
        state.done(k) = true;
        used(i) = true;
        break
      end
    end
  end
end
