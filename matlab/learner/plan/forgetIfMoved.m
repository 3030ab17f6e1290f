function state = forgetIfMoved(state)
% Forgets the impossible moves if a block was moved, was found, or is lost since the first of them.
  before = state.impossibleAmong;
  near = constants().task_planning.unmoved_distance;
  was_there = @(it) any(arrayfun(@(other) norm(it.position - other.position) < near, before));
  if numel(before) == numel(state.known) && all(arrayfun(was_there, state.known)), return; end
  state.impossibleMoves(:) = [];
  state.impossibleAmong = state.known;
end
