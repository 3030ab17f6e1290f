function [state, problem] = locateAsides(state, picture, heights, eye)
% Finds where the asides of the demonstration (see asideOf) are in the scene: state.alignments, under the names of their steps.
% A problem says if one is not there.
  problem = '';
  for step = state.steps(~cellfun(@isempty, {state.steps.aside}))
    found = locateControl(step.aside, picture, heights, eye, state.shown);
    if isempty(found)
      problem = sprintf('the place for %s is not visible', step.name);
      return
    end
    found.control = step.name;
    state.alignments(end + 1) = found;
  end
end
