function [actions, state] = planOneOf(open, state, free, eye, arms, sensor)
% Plans the next of some steps in the demonstrated order; while that is blocked, one of the others, next time: a 1xN cell
% of actions; {} if all are blocked.
%   open  their numbers
%   free  numbers of the known blocks that are in no step's place
  intention = state.intention;
  state.intention = [];
  is_next = ~isempty(intention) && (any(open == intention.step) || waitsForSupport(state, intention.step));
  if is_next, k = intention.step; else, k = open(1 + mod(state.numBlocked, numel(open))); end
  is_last_resort = (is_next && intention.isLastResort) || state.numBlocked >= numel(open);
  [actions, state, reason] = planStep(state, k, free, is_last_resort, eye, arms, sensor);
  if ~isempty(actions)
    state.numBlocked = 0;
    % What was put aside, or handed over, was for this step: it goes on.
    if any(open == k), state.intention = struct('step', k, 'isLastResort', is_last_resort); end
    return
  elseif is_next && ~is_last_resort
    [actions, state] = planOneOf(open, state, free, eye, arms, sensor);
    return
  end
  if state.numBlocked == 0, state.firstFailure = [describeStep(state.steps(k)), ': ', reason]; end
  state.numBlocked = state.numBlocked + 1;
  if state.numBlocked > numel(open) + 1
    [actions, state] = planHandLook(open, state, free, eye, arms, sensor);
    if ~isempty(actions), state.numBlocked = 0; end
  end
  if state.numBlocked > numel(open) + 1
    state = giveUp(state, ['at ', state.firstFailure]);
  elseif isempty(actions)
    actions = {struct('kind', 'observe')};
  end
end
