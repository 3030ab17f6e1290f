function open = openSteps(state)
% Returns the numbers of the steps that are not done and whose supports are done, in demonstrated order, or in that of a
% choice; before a press, only of those that were done before it.
  open = find(~state.done);
  pending = state.presses(~[state.presses.done]);
  if ~isempty(pending), open = intersect(open, pending(1).after); end
  open = open(arrayfun(@(k) all(state.done([state.steps(k).on, state.steps(k).after])), open));
  order = shuffled(1:numel(state.steps), state.choices.order);
  open = order(ismember(order, open));
end
