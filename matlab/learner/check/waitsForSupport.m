function yes = waitsForSupport(state, k)
% Returns true if step k, or [], stands on one that is not done.
  yes = ~isempty(k) && ~all(state.done(state.steps(k).on));
end
