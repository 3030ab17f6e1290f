function state = rememberFailure(state, actions)
% Remembers that the first of the remaining actions failed: its grasp is not repeated. Unless the block was
% released already, it is not where it was to go.
  if any(cellfun(@(action) strcmp(action.kind, 'open'), actions(2:end))), state.known(end) = []; end
  state.moved = '';
  state.failures(end + 1) = state.grasp;
end
