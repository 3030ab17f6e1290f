function [state, problem] = locateControls(state, picture, heights, eye)
% Finds where the controls of the demonstration are in the scene: state.alignments. A problem says if one is not there.
  problem = '';
  for press = state.presses
    if any(strcmp({state.alignments.control}, press.control)), continue; end
    found = locateControl(press, picture, heights, eye, state.shown);
    if isempty(found)
      problem = sprintf('the surroundings of %s are not visible', press.control);
      return
    end
    found.control = press.control;
    state.alignments(end + 1) = found;
  end
end
