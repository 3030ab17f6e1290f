function state = giveUp(state, reason)
% Ends the task unfinished, for a reason: one line.
  state.claim = struct('done', false, 'reason', reason);
end
