function state = rememberFailure(state, actions, status)
% Remembers that the first of the remaining actions failed, and how: its grasp is not repeated. Unless the block was
% released already, or pushed, it is not where it was to go.
  if strcmp(status, cannotLift()), state.grasp.tooHeavy = state.known(end); end
  if any(cellfun(@(action) any(strcmp(action.kind, {'open', 'push'})), actions(2:end))), state.known(end) = []; end
  state.moved = '';
  state.failures(end + 1) = state.grasp;
end
