function [actions, state] = chooseActions(state, sensor, eye, arms)
% Updates the beliefs from a picture and plans the next actions: a 1xN cell; {} when everything is built
% or no plan is found (state.summary says which).
  c = constants().task_planning;
  actions = {};
  container = state.container;
  if ~state.hasSite, container = []; end  % its place in this scene is not known yet
  picture = sensor.rgbVision;
  seen = detectBlocks(picture, eye, [asBlocks(state.steps), state.unknownObjects], container);
  if ~state.hasSite || state.numBlocked > 0
    state.unknownObjects = [state.unknownObjects, detectUnknownObjects(picture, eye, [seen, state.known])];
    seen = detectBlocks(picture, eye, [asBlocks(state.steps), state.unknownObjects], container);
  end
  state.known = updateBeliefs(state.known, seen, picture, eye);
  if ~state.hasSite
    state = chooseSite(state, arms, picture, eye);
    if ~state.hasSite, return; end
  end

  [state, used] = assessProgress(state);
  open = openSteps(state);
  if isempty(open)
    state.summary = sprintf('built, as seen within %.2f units and %.1f degrees', ...
                            max(state.placementErrors, [], 1) .* [1, 180 / pi]);
    return
  end

  % The next step in the demonstrated order; while that is blocked, one of the other open steps.
  k = open(1 + mod(state.numBlocked, numel(open)));
  reason = 'no matching block is visible';
  if state.attempts(k) >= c.max_attempts
    reason = sprintf('%d attempts failed', c.max_attempts);
  elseif state.numTemporary >= c.max_temporary_placements
    reason = sprintf('blocks were put aside %d times already', c.max_temporary_placements);
  else
    for move = proposeMoves(state, k, find(~used))
      [actions, place, reason] = planMove(state, k, move, eye, arms, sensor);
      if isempty(actions), continue; end
      state.numTemporary = state.numTemporary + ~isempty(place);
      state.attempts(k) = state.attempts(k) + isempty(place);
      state.known(move.block) = [];
      state.known = [state.known, place];
      state.numBlocked = 0;
      return
    end
  end
  if state.numBlocked == 0, state.firstFailure = [describeStep(state.steps(k)), ': ', reason]; end
  state.numBlocked = state.numBlocked + 1;
  if state.numBlocked > numel(open) + 1
    state.summary = ['gave up at ', state.firstFailure];
  else
    actions = {struct('kind', 'observe')};
  end
end

function open = openSteps(state)
% Returns the numbers of the steps that are not done and whose supports are done, in demonstrated order.
  open = find(~state.done);
  open = open(arrayfun(@(k) all(state.done(state.steps(k).on)), open));
end

function [actions, place, reason] = planMove(state, k, move, eye, arms, sensor)
% Plans one move: straight to its goal, if it has one and an arm reaches both places; otherwise to a
% temporary place, if necessary where a later step will be.
%   k      number of the current step
%   place  the block at its temporary place, which may be hidden there; a 1x0 struct array for a block
%          that is built in: there it must be seen
  block = state.known(move.block);
  others = [state.known([1:move.block - 1, move.block + 1:end]), assumedSupport(block), ...
            containerWalls(state.container)];
  steps = state.steps;
  container = asBlocks(state.container);
  sites = {[asBlocks(steps), container]};
  actions = {};
  place = noBlocks();
  if ~isempty(move.goal)
    sites{2} = [asBlocks(steps(state.done)), container];
    [actions, reason] = planPickAndPlace(arms, block, move.goal, others, sensor);
  elseif any(overlap(gripperClearance(steps(k)), footprint(block, 0)))
    sites{2} = [asBlocks(steps([find(state.done), k])), container];
  end
  if isempty(actions)
    [actions, place, reason] = planTemporaryPlacement(arms, eye, block, others, sites, sensor, move.goal);
  end
end
