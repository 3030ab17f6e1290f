function [state, used] = assessProgress(state)
% Compares the known blocks with the steps: updates state.done and state.placementErrors. A step is not done before
% those that must come before it.
%   used  which known blocks are in the place of a step, 1xN logical
  known = state.known;
  used = false(1, numel(known));
  state.done(:) = false;
  for k = 1:numel(state.steps)
    step = state.steps(k);
    if ~all(state.done(step.after)), continue; end
    for i = find(~used)
      if isInPlace(known(i), step)
        state.placementErrors(k, :) = [norm(known(i).position - step.position), ...
                                       abs(yawDifference(step, known(i).yaw))];
        state.done(k) = true;
        used(i) = true;
        break
      end
    end
  end
end
