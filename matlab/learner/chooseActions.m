function [actions, state] = chooseActions(state, sensor, eye, arms)
% Updates the beliefs from a picture and plans the next actions: a 1xN cell; {} when everything is built
% or no plan is found (state.claim says which).
  actions = {};
  picture = sensor.rgbVision;
  state = observe(state, picture, heightMap(sensor.depthVision, eye), eye);
  if ~state.hasSite
    [state, problem] = chooseSite(state, arms, picture, eye);
    if ~state.hasSite
      state = giveUp(state, ['before it began: ', problem]);
      return
    end
    state.notes = [state.notes, planNotes(state.steps)];
  end

  [state, used] = assessProgress(state);
  open = openSteps(state);
  if isempty(open)
    reason = sprintf('as seen within %.2f units and %.1f degrees', ...
                     max(state.placementErrors, [], 1) .* [1, 180 / pi]);
    state.claim = struct('done', true, 'reason', reason);
    return
  end

  % The next step in the demonstrated order; while that is blocked, one of the other open steps.
  k = open(1 + mod(state.numBlocked, numel(open)));
  [actions, state, reason] = planStep(state, k, find(~used), sensor, eye, arms);
  if ~isempty(actions), return; end
  if state.numBlocked == 0, state.firstFailure = [describeStep(state.steps(k)), ': ', reason]; end
  state.numBlocked = state.numBlocked + 1;
  if state.numBlocked > numel(open) + 1
    state = giveUp(state, ['at ', state.firstFailure]);
  else
    actions = {struct('kind', 'observe')};
  end
end

function open = openSteps(state)
% Returns the numbers of the steps that are not done and whose supports are done, in demonstrated order.
  open = find(~state.done);
  open = open(arrayfun(@(k) all(state.done([state.steps(k).on, state.steps(k).after])), open));
end
